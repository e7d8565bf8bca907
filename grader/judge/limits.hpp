// What a runner may use.
#pragma once

#include <cstddef>

namespace bounce::judge {

// Of a runner's life, all its questions together, but where it says otherwise.
struct Limits {
  int cpu_seconds = 1;
  double idle_seconds =
      2;  // without a wish to run, where it should answer; for all runners of a part
  int wall_seconds = 30;         // of our waiting for answers: lax, for a machine that is very busy
  int session_seconds = 200;     // on the wall, for all runners of a part
  int session_cpu_seconds = 30;  // likewise, of CPU time
  std::size_t memory = std::size_t{1} << 30;
  bool checked = false;  // the memory is counted as it is used: sanitizers reserve terabytes
  bool boxed = false;    // the command is a box, which tells when it is made
  std::size_t prints = std::size_t{8} << 20;  // bytes
};

}  // namespace bounce::judge
