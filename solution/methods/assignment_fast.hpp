// The assignment's scheme, the same steps to rounding in half the time.
//
// Flight: while y - rho >= delta no corner can be in contact, whatever theta is, and a step is six
// additions. Near the ground cos theta and sin theta are carried along: turning by x = dt omega,
//
//     cos(theta + x) = cos theta cos x - sin theta sin x,
//     sin(theta + x) = sin theta cos x + cos theta sin x,
//
// where for |x| <= 1/2 eight terms of the one series and seven of the other are exact to rounding,
// 1e-18 and 5e-17 (x^16 / 16!, x^15 / 15!). Larger turns, and
// every 256th step, take them from theta anew, so that rounding errors can't add up.
#pragma once

#include "assignment.hpp"

namespace bounce::methods {

struct Turn {
  double cosine, sine;
};

// cos x and sin x for |x| <= kLargestTurn, in Estrin's order, for a short chain of operations.
inline constexpr double kLargestTurn = 0.5;

[[gnu::always_inline]] inline Turn small_turn(double x) {
  constexpr double c2 = -1.0 / 2, c4 = 1.0 / 24, c6 = -1.0 / 720, c8 = 1.0 / 40320,
                   c10 = -1.0 / 3628800, c12 = 1.0 / 479001600, c14 = -1.0 / 87178291200.0;
  constexpr double s3 = -1.0 / 6, s5 = 1.0 / 120, s7 = -1.0 / 5040, s9 = 1.0 / 362880,
                   s11 = -1.0 / 39916800, s13 = 1.0 / 6227020800.0;
  const double z = x * x, z2 = z * z, z4 = z2 * z2;
  const double c =
      ((1 + c2 * z) + (c4 + c6 * z) * z2) + ((c8 + c10 * z) + (c12 + c14 * z) * z2) * z4;
  const double s = ((1 + s3 * z) + (s5 + s7 * z) * z2) + ((s9 + s11 * z) + s13 * z2) * z4;
  return {c, x * s};
}

class AssignmentFast {
 public:
  AssignmentFast(const Parameters& params, const Motion<double>& start) : k_(params), s_(start) {}

  // On copies, which the compiler can keep in registers.
  void steps(long n) {
    const StepConstants k = k_;
    Motion<double> s = s_;
    Turn turn = turn_;
    int fresh = fresh_;
    while (n > 0) {
      if (s.y - k.rho >= k.delta) {
        fresh = 0;
        do {
          fall(s, k);
        } while (--n > 0 && s.y - k.rho >= k.delta);
      } else {
        if (fresh-- == 0) {
          turn = {std::cos(s.theta), std::sin(s.theta)};
          fresh = 255;
        }
        step_near(s, turn, fresh, k);
        --n;
      }
    }
    s_ = s;
    turn_ = turn;
    fresh_ = fresh;
  }

  Motion<double> motion() const { return s_; }

 private:
  static void fall(Motion<double>& s, const StepConstants& k) {
    s.v_x += k.dv_x;
    s.v_y += k.dv_y;
    move(s, k);
  }

  static void step_near(Motion<double>& s, Turn& turn, int& fresh, const StepConstants& k) {
    const Arm<double> r = lowest_arm(k.half, turn.cosine, turn.sine);
    const bool contact = s.y + r.y < k.delta;  // eq. (11)
    if (contact) strike(s, r, k);
    fall(s, k);
    if (contact) s.y += k.delta;  // eq. (14)
    const double x = k.dt * s.omega;
    if (!(std::abs(x) <= kLargestTurn)) {
      fresh = 0;
      return;
    }
    const Turn by = small_turn(x);
    turn = {turn.cosine * by.cosine - turn.sine * by.sine,
            turn.sine * by.cosine + turn.cosine * by.sine};
  }

  StepConstants k_;
  Motion<double> s_;
  Turn turn_{};
  int fresh_ = 0;  // steps until turn_ is taken from theta again
};

}  // namespace bounce::methods
