// Part 1 ({{ points[1] }} points): {{ titles[1] }}, eqs. (3) to (6).
#pragma once

#include <bounce/types.hpp>

namespace bounce {

// The lowest corner of the square at configuration q: its height and its Jacobian.
//
//   q       (x, y, theta) of the centre: m, m, rad. Any theta, many turns included.
//   params  the side l, m. Nothing else in it is needed here.
//   returns J   = [J_t J_n], 3x2, with the moment arm r = corner - centre in the world frame;
//           phi = height of that corner above the ground, m, negative below it.
//
// If two corners are equally low, either may be returned.
Contact get_contacts(const Vector3& q, const Parameters& params);

}  // namespace bounce
