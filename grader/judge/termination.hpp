// How a program ended, in words: what happened, and what is likely the cause.
#pragma once

#include <string>

#include "limits.hpp"

namespace bounce::judge {

struct Termination {
  std::string status;  // of the score record: crashed, timed_out, out_of_memory, no_answer
  std::string sentence;
  std::string stack = {};  // of a crash: addresses in hexadecimal, with a space before each
};

// From a wait status and the end of what the program printed, which decides about words alone.
// A box's exit status of 128 + n stands for signal n, as a shell's does.
Termination termination_of(int wait_status, const Limits& limits, const std::string& last_print);

Termination out_of_cpu_time(const Limits& limits);
Termination out_of_memory(const Limits& limits);

}  // namespace bounce::judge
