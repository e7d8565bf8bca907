// Given: asks the four parts for a trajectory.
#pragma once

#include <bounce/types.hpp>

namespace bounce {

// What `simulate` returns. Throws std::runtime_error with a sentence that says where to look if
// that can't be shown.
Trajectory simulated(const State& start, const Parameters& params);

}  // namespace bounce
