// The limits on a runner.
#pragma once

#include <cstddef>

namespace bounce::judge {

// Each holds for the whole life of a runner, unless it says otherwise.
struct Limits {
  int cpu_seconds = 1;
  double idle_seconds = 2;       // asleep while it should answer; for all runners of a part
  int wall_seconds = 30;         // that we wait for answers: loose, for very busy machines
  int session_seconds = 200;     // wall clock, for all runners of a part
  int session_cpu_seconds = 30;  // CPU time, for all runners of a part
  std::size_t memory = std::size_t{1} << 30;
  // Without namespaces, the box's own limit counts the threads of all of the user's processes.
  std::size_t threads = 32;
  bool sanitized = false;  // memory is limited as it is used, because sanitizers reserve terabytes
  bool boxed = false;      // the command is a box, which reports when it is made
  std::size_t prints = std::size_t{8} << 20;  // bytes
};

}  // namespace bounce::judge
