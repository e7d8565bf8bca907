// Measures what a process uses, and whether it works or sleeps. On a busy machine a program that
// works may get no CPU either, but it is ready to run; one that sleeps isn't.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace bounce::judge {

// The current usage of a process and all its descendants together.
struct ProcessUsage {
  bool works = false;       // a thread runs, or could, or reads a page from a disk
  bool stopped = false;     // one was stopped, as by SIGSTOP
  std::size_t threads = 0;  // of the one that has most
  double cpu_seconds = 0;   // by the system's clocks, which count ns
  std::size_t memory = 0;   // resident bytes
};

// Empty if the system doesn't report it, or the process is gone.
std::optional<ProcessUsage> usage_of(pid_t pid);

// The processes that it has started, or taken over, and that still exist.
std::vector<pid_t> children_of(pid_t pid);

}  // namespace bounce::judge
