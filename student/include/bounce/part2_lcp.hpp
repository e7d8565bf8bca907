// Part 2 ({{ points[2] }} points): {{ titles[2] }}, eqs. (7) to (10).
#pragma once

#include <bounce/types.hpp>

namespace bounce {

// The LCP whose solution is the contact force over one time step.
//
//   J       [J_t J_n], 3x2, as part 1 returns it; any 3x2 matrix is allowed.
//   v       (v_x, v_y, omega) before the step: m/s, m/s, rad/s.
//   params  l, m, mu, epsilon, g and dt are all needed.
//   returns V, 4x4, and p, 4, in the order z = (f_n, f_t1, f_t2, lambda).
//
// V z + p is, row by row: the normal velocity after the step plus epsilon times the one before;
// lambda minus the tangential velocity after the step; lambda plus it; and mu f_n - f_t1 - f_t2.
Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params);

}  // namespace bounce
