// How a program ended, in words.
#pragma once

#include <string>

namespace bounce::judge {

struct Ending {
  std::string status;  // of the score record: crashed, timed_out, no_answer
  std::string sentence;
  std::string stack;  // of a crash: addresses in hexadecimal, with a space before each
};

// From a wait status, the limit on CPU time and the end of what the program printed.
// A box's exit status of 128 + n stands for signal n, as a shell's does.
Ending ending_of(int wait_status, int cpu_seconds, const std::string& last_print);

}  // namespace bounce::judge
