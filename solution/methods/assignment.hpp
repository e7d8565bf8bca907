// The assignment's scheme, eqs. (11) to (14), with the LCP in closed form: semi-implicit Euler, one
// corner, contact where phi < delta at the start of the step, and a lift by delta.
//
//     contact:  v' = v + dt g + M^-1 J p,   q' = q + dt v' + (0, delta, 0)
//
// with p of one_corner.hpp. With a fixed delta it converges to a motion that bounces delta too high
// and hovers at rest; with delta proportional to dt, here delta = speed dt, it converges to the
// motion itself: with order 1 where contacts are impacts, and
// about 1/2 where they last.
//
// The lowest corner is found without a search: the four arms differ by right angles, so that r_y =
// -(|cos| + |sin|) l / 2, and the signs of r_x follow.
#pragma once

#include "one_corner.hpp"
#include "square.hpp"

namespace bounce::methods {

// What a step needs of the parameters: l / 2 and the distance of a corner, m; r_g^2, m^2; mu and
// epsilon; dt, s; delta, m; and dt g, m/s. g(2) of the parameters has to be 0.
struct StepConstants {
  double half, rho, gyration_squared, mu, epsilon, dt, delta, dv_x, dv_y;

  explicit StepConstants(const Parameters& params)
      : half(params.l / 2),
        rho(half * std::sqrt(2.0)),
        gyration_squared(params.l * params.l / 6),
        mu(params.mu),
        epsilon(params.epsilon),
        dt(params.dt),
        delta(params.delta),
        dv_x(params.dt * params.g.x()),
        dv_y(params.dt * params.g.y()) {}
};

inline Arm<double> lowest_arm(double half, double cosine, double sine) {
  return {half * (std::copysign(1.0, cosine) * sine - std::copysign(1.0, sine) * cosine),
          -half * (std::abs(cosine) + std::abs(sine))};
}

// Adds a contact's impulse to v, before gravity.
inline void strike(Motion<double>& s, const Arm<double>& r, const StepConstants& k) {
  const double u_n = (1 + k.epsilon) * normal_velocity(s, r) + k.dv_y;
  const double u_t = tangential_velocity(s, r) + k.dv_x;
  const auto p = solve_one_corner(one_corner(r, k.gyration_squared, u_n, u_t, k.mu));
  apply_impulse(s, r, p.n, p.t, k.gyration_squared);
}

inline void move(Motion<double>& s, const StepConstants& k) {
  s.x += k.dt * s.v_x;
  s.y += k.dt * s.v_y;
  s.theta += k.dt * s.omega;
}

class Assignment {
 public:
  Assignment(const Parameters& params, const Motion<double>& start) : k_(params), s_(start) {}

  void steps(long n) {
    for (; n > 0; --n) step();
  }

  Motion<double> motion() const { return s_; }

 private:
  void step() {
    const Arm<double> r = lowest_arm(k_.half, std::cos(s_.theta), std::sin(s_.theta));
    const bool contact = s_.y + r.y < k_.delta;  // eq. (11)
    if (contact) strike(s_, r, k_);
    s_.v_x += k_.dv_x;
    s_.v_y += k_.dv_y;
    move(s_, k_);
    if (contact) s_.y += k_.delta;  // eq. (14)
  }

  StepConstants k_;
  Motion<double> s_;
};

inline Parameters with_delta_per_dt(Parameters params, double speed) {
  params.delta = speed * params.dt;
  return params;
}

}  // namespace bounce::methods
