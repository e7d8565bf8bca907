// Measures what a process uses, and whether it waits or is only slow. On a busy machine a slow
// program also gets no CPU, but it is ready to run; a waiting one isn't.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace bounce::judge {

// The current usage of a process and all its descendants together.
struct ProcessUsage {
  bool reads_a_disk = false;  // a thread is in uninterruptible sleep
  bool stopped = false;       // one was stopped, as by SIGSTOP
  bool ready = false;         // a thread runs, or could
  std::size_t threads = 0;    // of the one that has most
  double cpu_seconds = 0;     // by the system's clocks, which count ns
  double delay_seconds = 0;   // ready to run while no CPU was free; of threads that still exist
  double ended_seconds = 0;   // CPU time of threads that have ended, at least
  std::size_t memory = 0;     // resident bytes
};

// Empty if the system doesn't report it, or the process is gone.
std::optional<ProcessUsage> usage_of(pid_t pid);

// The processes that it has started, or taken over, and that still exist.
std::vector<pid_t> children_of(pid_t pid);

// For how long this process was ready to run while no CPU was free, and for how long the host of a
// virtual machine gave its CPUs to others (steal time), s.
double own_delay_seconds();

// For how long the CPU of this process, which stays there, had nothing to do, s; in steps of 10 ms.
double spare_seconds();

}  // namespace bounce::judge
