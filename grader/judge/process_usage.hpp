// Does a program wait, or is it only slow? A busy machine keeps a program from its CPU, too; but
// then it is ready to run, and a program that waits isn't.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <optional>

namespace bounce::judge {

// What the system says at one moment of a process and all its descendants, taken together.
struct ProcessUsage {
  bool reads_a_disk = false;  // one of them waits where no signal reaches it
  bool stopped = false;       // one was stopped, as by SIGSTOP
  double cpu_seconds = 0;
  double busy_seconds = 0;  // CPU time, and time in which a CPU was wanted and not to be had
  std::size_t memory = 0;   // bytes that are really used
};

// Empty where this system doesn't tell, or the process is gone.
std::optional<ProcessUsage> usage_of(pid_t pid);

// For how long this process has been ready to run, and no CPU was free, s.
double own_delay_seconds();

// The CPU time of a process and its descendants, ns, by the system's own clocks. Finer than a
// ProcessUsage, which counts in hundredths of a second. Empty as above.
std::optional<double> cpu_ns_of(pid_t pid);

}  // namespace bounce::judge
