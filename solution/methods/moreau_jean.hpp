// Moreau's sweeping process, discretised by the midpoint rule (Moreau 1988, section 14; Jean 1999,
// "The non-smooth contact dynamics method", CMAME 177; Acary & Brogliato 2008, chapter 10).
//
//     q_m = q + dt v / 2                                  half of the step with the old velocity
//     v'  = v + dt g + M^-1 J(q_m) p                      contacts: corners with phi(q_m) <= 0
//     0 <= p_n  perpendicular to  v_n' + epsilon v_n >= 0,   Coulomb with v_t'
//     q'  = q_m + dt v' / 2                               the other half with the new one
//
// Free flight is exact. There is no delta, rest is exact rest, and impacts come up to a step too
// late: order 1, and a depth up to v dt. Restitution belongs to corners that approach: with two,
// epsilon v_n of one that leaves would let it come back through the ground.
//
// kCorners 1 takes the lowest corner only. kCorners 2 takes the two lowest, with merged friction.
#pragma once

#include "assignment.hpp"
#include "two_corners.hpp"

namespace bounce::methods {

// The lowest two corners at q_m: their arms and whether they touch.
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

// The impulses of one step on the corners that touch, added to v.
inline void strike_side(Motion<double>& s, const LowCorners& low, const StepConstants& k) {
  const auto u_n = [&](const Arm<double>& r) {
    const double v_n = normal_velocity(s, r);
    return v_n + k.epsilon * std::min(v_n, 0.0) + k.dv_y;
  };
  const double r_y = (low.left.y + low.right.y) / 2;
  const auto p = solve_two_corners(two_corners<double>(low.left, low.right, k.gyration,
                                                       {u_n(low.left), u_n(low.right)},
                                                       s.v_x - r_y * s.omega + k.dv_x, k.mu));
  push(s, low.left, p.n[0], p.t / 2, k.gyration);
  push(s, low.right, p.n[1], p.t / 2, k.gyration);
}

template <int kCorners>
class MoreauJean {
 public:
  MoreauJean(const Parameters& params, const Motion<double>& start) : k_(params), s_(start) {}

  void steps(long n) {
    for (; n > 0; --n) step();
  }

  Motion<double> motion() const { return s_; }

 private:
  void step() {
    half_step();
    if (s_.y <= k_.rho) touch();
    s_.v_x += k_.dv_x;
    s_.v_y += k_.dv_y;
    half_step();
  }

  void half_step() {
    s_.x += k_.dt / 2 * s_.v_x;
    s_.y += k_.dt / 2 * s_.v_y;
    s_.theta += k_.dt / 2 * s_.omega;
  }

  void touch() {
    const LowCorners low = low_corners(k_.half, std::cos(s_.theta), std::sin(s_.theta), s_.y);
    const bool left = low.gap_left <= 0, right = low.gap_right <= 0;
    if (kCorners == 2 && left && right) {
      strike_side(s_, low, k_);
    } else if (left || right) {
      strike(s_, low.gap_left <= low.gap_right ? low.left : low.right, k_);
    }
  }

  StepConstants k_;
  Motion<double> s_;
};

}  // namespace bounce::methods
