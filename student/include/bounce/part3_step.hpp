// Part 3 ({{ points[3] }} points): {{ titles[3] }}, eqs. (11) to (14).
#pragma once

#include <bounce/types.hpp>

namespace bounce {

// The state one time step later.
//
//   q       (x, y, theta) of the centre: m, m, rad.
//   v       (v_x, v_y, omega): m/s, m/s, rad/s.
//   params  every number but T is needed, dt in s and delta in m among them.
//   returns q and v at the end of the step, in the same units.
//
// The contact is tested at the start of the step: phi(q) < delta, strictly.
State step(const Vector3& q, const Vector3& v, const Parameters& params);

}  // namespace bounce
