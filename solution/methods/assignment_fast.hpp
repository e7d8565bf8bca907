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
//
// Divisions: with X = r_x / r_g, Y = r_y / r_g and W = r_g omega, a = 1 + X^2, b = -X Y, c = 1 +
// Y^2 and v_n = v_y + X W, v_t = v_x - Y W, W' = W + X p_n - Y p_t: r_g^2 is never divided by. What
// is left is one reciprocal, that of D or of a -+ mu b, which depends on the angle only and so is
// ready before the velocities are.
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

// The same for |x| <= 1/8, where fewer terms do (x^10 / 10! is 3e-16) and the chain is shorter.
inline constexpr double kSmallTurn = 0.125;

inline Turn smaller_turn(double x) {
  const double z = x * x, z2 = z * z;
  const double c = (1 - z / 2) + z2 * ((1.0 / 24 - z * (1.0 / 720)) + z2 * (1.0 / 40320));
  const double s =
      (1 - z * (1.0 / 6)) + z2 * ((1.0 / 120 - z * (1.0 / 5040)) + z2 * (1.0 / 362880));
  return {c, x * s};
}

class AssignmentFast {
 public:
  AssignmentFast(const Parameters& params, const Motion<double>& start)
      : k_(params),
        r_g_(std::sqrt(k_.gyration)),
        half_(k_.half / r_g_),
        dt_theta_(k_.dt / r_g_),
        now_{start, {}, 0} {
    now_.s.omega *= r_g_;
  }

  // On copies, which the compiler can keep in registers.
  void steps(long n) {
    const AssignmentFast scheme = *this;
    Carried c = now_;
    while (n > 0) {
      for (; n > 0 && c.s.y - scheme.k_.rho >= scheme.k_.delta; --n, c.fresh = 0) scheme.fall(c.s);
      for (; n > 0 && !(c.s.y - scheme.k_.rho >= scheme.k_.delta); --n)
        scheme.step_near(c);  // NaN too
    }
    now_ = c;
  }

  Motion<double> motion() const {
    Motion<double> s = now_.s;
    s.omega /= r_g_;
    return s;
  }

 private:
  // What goes from step to step.
  struct Carried {
    Motion<double> s;  // with W in place of omega
    Turn turn;
    int fresh;  // steps until turn is taken from theta again
  };

  void fall(Motion<double>& s) const {
    s.v_x += k_.dv_x;
    s.v_y += k_.dv_y;
    s.x += k_.dt * s.v_x;
    s.y += k_.dt * s.v_y;
    s.theta += dt_theta_ * s.omega;
  }

  void step_near(Carried& c) const {
    if (c.fresh-- == 0) {
      c.turn = {std::cos(c.s.theta), std::sin(c.s.theta)};
      c.fresh = 255;
    }
    const Arm<double> r = lowest_arm(half_, c.turn.cosine, c.turn.sine);  // (X, Y)
    const bool contact = c.s.y + r_g_ * r.y < k_.delta;                   // eq. (11)
    if (contact) strike_scaled(c.s, r);
    fall(c.s);
    if (contact) c.s.y += k_.delta;  // eq. (14)
    turn_by(dt_theta_ * c.s.omega, c);
  }

  // The cases of one_corner.hpp. While the corner slides, p_t = f p_n with f = -+mu, so that the
  // divisor is 1 + X (X - f Y), and W' = W + (X - f Y) p_n.
  void strike_scaled(Motion<double>& s, const Arm<double>& r) const {
    const double bounce = 1 + k_.epsilon;
    const double u_n = (bounce * s.v_y + k_.dv_y) + (bounce * r.x) * s.omega;
    if (u_n >= 0) return;
    const double u_t = (s.v_x + k_.dv_x) - r.y * s.omega;
    const double a = 1 + r.x * r.x, b = -r.x * r.y, c = 1 + r.y * r.y;
    const double N = b * u_t - c * u_n, T = b * u_n - a * u_t;
    if (std::abs(T) <= k_.mu * N) {
      const double per_D = 1 / (a * c - b * b), p_n = N * per_D, p_t = T * per_D;
      s.v_x += p_t;
      s.v_y += p_n;
      s.omega += r.x * p_n - r.y * p_t;
      return;
    }
    const double f = T < 0 ? -k_.mu : k_.mu, lever = r.x - f * r.y;
    const double per_divisor = 1 / (1 + r.x * lever), p_n = -u_n * per_divisor;
    s.v_x += f * p_n;
    s.v_y += p_n;
    s.omega -= u_n * (lever * per_divisor);
  }

  static void turn_by(double x, Carried& c) {
    Turn by;
    if (std::abs(x) <= kSmallTurn) {
      by = smaller_turn(x);
    } else if (std::abs(x) <= kLargestTurn) {
      by = small_turn(x);
    } else {
      c.fresh = 0;
      return;
    }
    c.turn = {c.turn.cosine * by.cosine - c.turn.sine * by.sine,
              c.turn.sine * by.cosine + c.turn.cosine * by.sine};
  }

  StepConstants k_;
  double r_g_, half_, dt_theta_;  // m; l / 2 r_g, none; dt / r_g, s/m
  Carried now_;
};

}  // namespace bounce::methods
