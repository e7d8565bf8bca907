#pragma once

#include <bounce/types.hpp>

// The corner k = 0..3 of the square in the world frame. Defined in part1_contacts.cpp.
Eigen::Vector2d corner(int k, const bounce::Vector3& q, const bounce::Parameters& params);
int lowest_corner(const bounce::Vector3& q, const bounce::Parameters& params);
