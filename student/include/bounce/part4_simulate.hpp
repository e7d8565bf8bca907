// Part 4 ({{ points[4] }} points): {{ titles[4] }}, eq. (15).
#pragma once

#include <bounce/types.hpp>

namespace bounce {

// The trajectory that starts at (q_0, v_0).
//
//   q_0     (x, y, theta) of the centre at the start: m, m, rad.
//   v_0     (v_x, v_y, omega) at the start: m/s, m/s, rad/s.
//   params  params.T is the number of columns, at least 1; the rest goes on to step.
//   returns q and v, 3xT each: column 0 is (q_0, v_0), column t+1 is one step from column t.
Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params);

}  // namespace bounce
