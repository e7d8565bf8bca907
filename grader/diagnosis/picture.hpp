// Draws small pictures made of letters, for any terminal.
#pragma once

#include "cases.hpp"

namespace bounce::tests {

// The square before the step, and the right and another velocity of its centre after the step.
std::string picture_of_step(const Case& c, const Vector3& got_v);

// The right path of the centre, and another.
std::string picture_of_paths(const Case& c, const Eigen::Matrix3Xd& got_q);

}  // namespace bounce::tests
