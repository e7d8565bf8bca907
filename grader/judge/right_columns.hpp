// Whether the columns of a trajectory are right, each as the step from the one before: over a whole
// trajectory rounding errors grow too much for a comparison.
#pragma once

#include <bounce/types.hpp>
#include <optional>

namespace bounce::judge {

// The first column that isn't the solution's step from the column before, or for column 0 not
// `start`. Where rounding decides what happens in a step (decidable.hpp), a column is also right if
// it is the solution's step from a state that differs by as little.
std::optional<Eigen::Index> wrong_column(const Trajectory& trajectory, const State& start,
                                         const Parameters& params);

}  // namespace bounce::judge
