// The assignment's scheme, eqs. (11) to (14), with the LCP in closed form: semi-implicit Euler, one
// corner, contact where phi < delta at the start of the step, and a lift by delta.
//
//     contact:  v' = v + dt g + M^-1 J p,   q' = q + dt v' + (0, delta, 0)
//
// with p of one_corner.hpp. With a fixed delta it converges to a motion that bounces delta too high
// and hovers at rest; with delta proportional to dt, here delta = speed dt, it converges to the
// motion itself: with order 1 where contacts are impacts, and
// about 1/2 where they last.
#pragma once

#include "one_corner.hpp"
#include "scheme.hpp"

namespace bounce::study {

struct Assignment : StepConstants {
  using StepConstants::StepConstants;

  void step(Motion<double>& s) const {
    const Arm<double> r = lowest_arm(half, std::cos(s.theta), std::sin(s.theta));
    const bool contact = s.y + r.y < delta;  // eq. (11)
    if (contact) strike(s, r);
    s.v_x += dv_x;
    s.v_y += dv_y;
    move(s, dt);
    if (contact) s.y += delta;  // eq. (14)
  }

  // Adds a contact's impulse to v, before gravity.
  void strike(Motion<double>& s, const Arm<double>& r) const {
    const double u_n = (1 + epsilon) * normal_velocity(s, r) + dv_y;
    const double u_t = tangential_velocity(s, r) + dv_x;
    const auto p = solve_one_corner(one_corner(r, gyration_squared, u_n, u_t, mu));
    apply_impulse(s, r, p.n, p.t, gyration_squared);
  }
};

}  // namespace bounce::study
