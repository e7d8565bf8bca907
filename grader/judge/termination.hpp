// How a program ended, as facts, and the limits that may end it.
// grader/words/endings.txt says what they mean.
#pragma once

#include <cstddef>
#include <string>

namespace bounce::judge {

// Each holds for the whole life of a runner, unless it says otherwise.
struct Limits {
  int cpu_seconds = 1;
  double wall_seconds = 5;     // that all runners of a part are waited for: then one may not sleep
  int busy_wall_seconds = 30;  // that one is waited for, though it works: the machine is too busy
  int session_seconds = 200;   // wall clock, for all runners of a part
  int session_cpu_seconds = 30;  // CPU time, for all runners of a part
  std::size_t memory = std::size_t{1} << 30;
  // Without namespaces, the box's own limit is higher, as it counts all of the user's processes.
  std::size_t threads = 32;
  bool sanitized = false;  // memory is limited as it is used, because sanitizers reserve terabytes
  bool boxed = false;      // the command is a box, which reports when it is made
  std::size_t prints = std::size_t{8} << 20;  // bytes
};

// Thrown where a runner can't go on.
struct Termination {
  std::string status = {};  // of the score record: crashed, timed_out, out_of_memory, no_answer ...
  std::string what = {};    // a name in grader/words/endings.txt
  long number = 0;          // which belongs to it: an exit status, a signal, a limit
  std::string text = {};    // likewise; of an abort what the program printed last, any bytes
  std::string stack = {};   // of a crash: hexadecimal addresses, each after a space
  bool waits = false;       // for ever, and would do so again: no more is asked of this part
  bool of_no_case = false;  // it concerns the whole check, such as a used-up time
};

// From a wait status, and from the last text that the program printed, which may be anything and
// changes only `text`, and which memory is to blame. As with a shell, a box's exit status of 128 +
// n stands for signal n. memory is the most that it held, in bytes.
Termination termination_of(int wait_status, const Limits& limits, const std::string& last_print,
                           std::size_t memory = 0);

// A loop that allocates without end may reach either limit first, which depends on the machine's
// load. So a program that held at least an eighth of its memory is out of memory in both cases.
Termination out_of_cpu_time(const Limits& limits, std::size_t memory = 0);
Termination out_of_memory(const Limits& limits);

// "no_answer: exited 7", with what belongs to it; for tests.
std::string in_one_line(const Termination& end);

}  // namespace bounce::judge
