// Describes how a program ended: what happened, and the likely cause.
#pragma once

#include <string>

#include "limits.hpp"

namespace bounce::judge {

struct Termination {
  std::string status;  // of the score record: crashed, timed_out, out_of_memory, no_answer
  std::string sentence;
  std::string stack = {};  // of a crash: hexadecimal addresses, each after a space
  std::string by = {};     // what explains a crash, if something does: "assertion" or "sanitizer"
};

// From a wait status, and from the last text that the program printed, which changes only the
// message. As with a shell, a box's exit status of 128 + n stands for signal n. memory is the most
// that it held, in bytes.
Termination termination_of(int wait_status, const Limits& limits, const std::string& last_print,
                           std::size_t memory = 0);

// A loop that allocates without end may reach either limit first, which depends on the machine's
// load. So a program that held at least an eighth of its memory is out of memory in both cases.
Termination out_of_cpu_time(const Limits& limits, std::size_t memory = 0);
Termination out_of_memory(const Limits& limits);

}  // namespace bounce::judge
