// What a runner may use.
#pragma once

#include <cstddef>

namespace bounce::judge {

// Of a runner's life, all its questions together; but session_seconds are for all runners of a
// part, so that the judge ends by itself.
struct Limits {
  int cpu_seconds = 1;
  int idle_seconds = 1;   // found asleep, without a wish to run, where it should have answered
  int wall_seconds = 30;  // of our waiting for answers: lax, for a machine that is very busy
  int session_seconds = 200;
  std::size_t memory = std::size_t{1} << 30;
  bool checked = false;  // the memory is counted as it is used: sanitizers reserve terabytes
  std::size_t prints = std::size_t{8} << 20;  // bytes
};

}  // namespace bounce::judge
