// Checks a trajectory at any dt: each column must be the solution's step from the column before.
//
// Whole trajectories can't be compared, because rounding errors grow over many columns.
#pragma once

#include <bounce/types.hpp>
#include <optional>

namespace bounce::judge {

// The first column that isn't the solution's step from the column before (for column 0: `start`),
// with the tolerance of the checks. Skips steps that rounding decides (decidable.hpp).
std::optional<Eigen::Index> wrong_column(const Trajectory& trajectory, const State& start,
                                         const Parameters& params);

}  // namespace bounce::judge
