// Small pictures made of letters, for a terminal of any kind.
#pragma once

#include "cases.hpp"

namespace bounce::tests {

// The square before the step, and the velocities of its centre after it, the right one and another.
std::string picture_of_step(const Case& c, const Vector3& got_v);

// The way of the centre: the right one, and another.
std::string picture_of_paths(const Case& c, const Eigen::Matrix3Xd& got_q);

}  // namespace bounce::tests
