// Moreau's sweeping process, discretised by the midpoint rule (Moreau 1988, section 14; Jean 1999,
// "The non-smooth contact dynamics method", CMAME 177; Acary & Brogliato 2008, chapter 10).
//
//     q_m = q + dt v / 2                            half of the step with the old velocity
//     v'  = v + dt g + M^-1 J(q_m) p                contacts: corners with phi(q_m) <= 0
//     0 <= p_n  perpendicular to  v_n' + epsilon min(v_n, 0) >= 0,   Coulomb with v_t'
//     q'  = q_m + dt v' / 2                         the other half with the new one
//
// Free flight is exact. There is no delta, rest is exact, and impacts come up to a step too late:
// order 1, and a depth up to v dt. Restitution applies only to corners that approach: for one that
// leaves, epsilon v_n would let it come back through the ground.
//
// A square that turns about a sticking corner moves along the tangent of a circle, so the corner
// rises by up to rho omega^2 dt^2 from one q_m to the next. Without contact it then falls by up to
// g dt^2. So it is in contact only in some steps, and when its neighbour lands, chance would decide
// whether the impact is one of one corner or of two. Hence a corner this low counts as in contact
// while the other touches.
//
// kCorners 1 takes the lowest corner only. kCorners 2 takes the two lowest, with merged friction.
#pragma once

#include "one_corner.hpp"
#include "scheme.hpp"
#include "two_corners.hpp"

namespace bounce::study {

// The lowest two corners at q_m: their arms and their heights above the ground, m.
struct LowCorners {
  Arm<double> left, right;  // the lower side of the square, from left to right
  double gap_left, gap_right;
};

// The lowest corner is (r_x, r_y); its lower neighbour is on the side that r_x leans away from.
inline LowCorners low_corners(double half, double cosine, double sine, double y) {
  const Arm<double> r = lowest_arm(half, cosine, sine);
  const Arm<double> left = r.x <= 0 ? r : Arm<double>{r.y, -r.x};
  const Arm<double> right = r.x <= 0 ? Arm<double>{-r.y, r.x} : r;
  return {left, right, y + left.y, y + right.y};
}

// The contact problems of a step, at q_m.
struct Midpoint : StepConstants {
  using StepConstants::StepConstants;

  // Whether one corner is at or below the ground, and the other no further above than a sticking
  // one may be.
  bool side_touches(const LowCorners& low, const Motion<double>& s) const {
    const auto [lower, higher] = std::minmax(low.gap_left, low.gap_right);
    const double turn = dt * s.omega;
    return lower <= 0 && higher <= rho * turn * turn + dt * std::abs(dv_y);
  }

  // The normal row without impulses.
  double normal_row(const Motion<double>& s, const Arm<double>& r) const {
    const double v_n = normal_velocity(s, r);
    return v_n + epsilon * std::min(v_n, 0.0) + dv_y;
  }

  OneCorner<double> corner_problem(const Motion<double>& s, const Arm<double>& r) const {
    const double u_t = tangential_velocity(s, r) + dv_x;
    return one_corner(r, gyration_squared, normal_row(s, r), u_t, mu);
  }

  TwoCorners<double> side_problem(const Motion<double>& s, const LowCorners& low) const {
    const double u_t = s.v_x - (low.left.y + low.right.y) / 2 * s.omega + dv_x;
    return two_corners<double>(low.left, low.right, gyration_squared,
                               {normal_row(s, low.left), normal_row(s, low.right)}, u_t, mu);
  }

  void push(Motion<double>& s, const LowCorners& low, const SideImpulse<double>& p) const {
    push_side(s, low.left, low.right, p, gyration_squared);
  }
};

template <int kCorners>
struct MoreauJean : Midpoint {
  using Midpoint::Midpoint;

  void step(Motion<double>& s) const {
    move(s, dt / 2);
    if (s.y <= rho) touch(s);
    s.v_x += dv_x;
    s.v_y += dv_y;
    move(s, dt / 2);
  }

  void touch(Motion<double>& s) const {
    const LowCorners low = low_corners(half, std::cos(s.theta), std::sin(s.theta), s.y);
    if (kCorners == 2 && side_touches(low, s)) {
      push(s, low, solve_two_corners(side_problem(s, low)));
    } else if (low.gap_left <= 0 || low.gap_right <= 0) {
      const Arm<double>& r = low.gap_left <= low.gap_right ? low.left : low.right;
      const auto p = solve_one_corner(corner_problem(s, r));
      apply_impulse(s, r, p.n, p.t, gyration_squared);
    }
  }
};

}  // namespace bounce::study
