// The assignment's scheme, the same steps to rounding in less than half the time.
//
// Flight: while y - rho >= delta no corner can be in contact, whatever theta is, and a step is five
// additions. Near the ground cos theta and sin theta are carried along: turning by x = dt omega,
//
//     cos(theta + x) = cos theta cos x - sin theta sin x,
//     sin(theta + x) = sin theta cos x + cos theta sin x,
//
// where for |x| <= 1/2 eight terms of the one series and seven of the other are exact to rounding,
// 1e-18 and 5e-17 (x^16 / 16!, x^15 / 15!). Larger turns, and every 256th step, take them from
// theta anew, so that rounding errors can't add up.
//
// A step waits for the one before: it needs its angle, and the angle needs the impulse. What counts
// is therefore the longest chain of operations from angle to angle, and three things keep it short.
//
// Units: with X = r_x / r_g, Y = r_y / r_g and W = r_g omega, both a and c lose their division, and
// v_n = v_y + X W, v_t = v_x - Y W, W' = W + X p_n - Y p_t. The turn x is carried in place of W.
//
// Sticking: with w = (X, -Y) the matrix of one_corner.hpp is G = 1 + w w^T, and X^2 + Y^2 = 3 for a
// square, whatever its angle: det G = 4, and
//
//     p = -G^-1 u = -u + w K / 4,    K = w^T u = X u_n - Y u_t,    W' = W - K / 4
//
// (Sherman & Morrison 1950), without any division.
//
// Sliding: p_t = f p_n with f = -+mu, so that p_n = -u_n / (1 + X (X - f Y)), W' = W + (X - f Y)
// p_n. The divisor depends on the angle only; each direction is a branch of its own, which the
// processor foresees, so that the division does not wait for the velocities.
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

// A turn by |x| <= 1/32, where four terms do: x^8 / 8! is 2e-17. x sin theta is ready before the
// series are.
inline constexpr double kSmallTurn = 1.0 / 32;

inline Turn turned_a_little(const Turn& turn, double x) {
  const double z = x * x, z2 = z * z;
  const double c = (1 - z / 2) + z2 * (1.0 / 24 - z * (1.0 / 720));
  const double s_per_x = (1 - z * (1.0 / 6)) + z2 * (1.0 / 120 - z * (1.0 / 5040));
  return {turn.cosine * c - (x * turn.sine) * s_per_x, turn.sine * c + (x * turn.cosine) * s_per_x};
}

inline Turn turned(const Turn& turn, double x) {
  const Turn by = small_turn(x);
  return {turn.cosine * by.cosine - turn.sine * by.sine,
          turn.sine * by.cosine + turn.cosine * by.sine};
}

class AssignmentFast {
 public:
  AssignmentFast(const Parameters& params, const Motion<double>& start)
      : k_(params),
        r_g_(std::sqrt(k_.gyration_squared)),
        half_(k_.half / r_g_),
        turn_per_speed_(k_.dt / r_g_),
        speed_per_turn_(r_g_ / k_.dt),
        now_{start, {}, 0} {
    now_.s.omega *= k_.dt;
  }

  // Works on copies, which the compiler can keep in registers.
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
    s.omega /= k_.dt;
    return s;
  }

 private:
  // The state that is passed from step to step.
  struct Carried {
    Motion<double> s;  // with the turn of a step, x, in place of omega
    Turn turn;         // cos theta and sin theta, times l / 2 r_g
    int fresh;         // steps until turn is taken from theta again
  };

  void fall(Motion<double>& s) const {
    s.v_x += k_.dv_x;
    s.v_y += k_.dv_y;
    s.x += k_.dt * s.v_x;
    s.y += k_.dt * s.v_y;
    s.theta += s.omega;
  }

  void step_near(Carried& c) const {
    if (c.fresh-- == 0) {
      c.turn = {half_ * std::cos(c.s.theta), half_ * std::sin(c.s.theta)};
      c.fresh = 255;
    }
    const Arm<double> r = lowest_arm(1.0, c.turn.cosine, c.turn.sine);  // (X, Y)
    const bool contact = c.s.y + r_g_ * r.y < k_.delta;                 // eq. (11)
    if (contact) strike_scaled(c.s, r);
    fall(c.s);
    if (contact) c.s.y += k_.delta;  // eq. (14)
    turn_by(c.s.omega, c);
  }

  // The cases of one_corner.hpp.
  void strike_scaled(Motion<double>& s, const Arm<double>& r) const {
    const double W = speed_per_turn_ * s.omega, bounce = 1 + k_.epsilon;
    const double u_n = (bounce * s.v_y + k_.dv_y) + r.x * (bounce * W);
    if (u_n >= 0) return;
    const double u_t = (s.v_x + k_.dv_x) - r.y * W;
    const double quarter = (r.x * u_n - r.y * u_t) / 4;  // K / 4
    const double p_n = r.x * quarter - u_n, p_t = -(r.y * quarter + u_t);
    if (std::abs(p_t) <= k_.mu * p_n) {
      s.v_x += p_t;
      s.v_y += p_n;
      s.omega -= turn_per_speed_ * quarter;
    } else if (p_t < 0) {
      slide(s, r, u_n, -k_.mu);
    } else {
      slide(s, r, u_n, k_.mu);
    }
  }

  [[gnu::always_inline]] void slide(Motion<double>& s, const Arm<double>& r, double u_n,
                                    double f) const {
    const double lever = r.x - f * r.y, per_divisor = 1 / (1 + r.x * lever);
    const double p_n = -u_n * per_divisor;
    s.v_x += f * p_n;
    s.v_y += p_n;
    s.omega -= (u_n * (turn_per_speed_ * lever)) * per_divisor;
  }

  static void turn_by(double x, Carried& c) {
    if (std::abs(x) <= kSmallTurn) {
      c.turn = turned_a_little(c.turn, x);
    } else if (std::abs(x) <= kLargestTurn) {
      c.turn = turned(c.turn, x);
    } else {
      c.fresh = 0;
    }
  }

  StepConstants k_;
  double r_g_, half_;                       // m; l / 2 r_g, none
  double turn_per_speed_, speed_per_turn_;  // dt / r_g, s/m, and its inverse
  Carried now_;
};

}  // namespace bounce::methods
