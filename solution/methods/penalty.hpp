// A spring and a damper at every corner that is below the ground (Cundall & Strack 1979, "A
// discrete numerical model for granular assemblies", Geotechnique 29), per unit of mass:
//
//     f_n = max(0, -stiffness phi - damping v_n),   f_t = -v_t damping_t within +-mu f_n,
//
// and semi-implicit Euler. Corners that touch and approach at the same v_n act like a mass 1 / a on
// such a spring, a_i = sum_j (1 + r_ix r_jx / r_g^2) over them. With damping = 2 zeta
// sqrt(stiffness / a) and a spring that doesn't pull, contact ends where f_n does, and restitution
// is (Schwager & Poschel 2007, "Coefficient of restitution and linear-dashpot model revisited",
// Granular Matter 9)
//
//     epsilon = exp(-2 zeta arccos zeta / sqrt(1 - zeta^2)) = exp(-2 beta cot beta),
//     zeta = cos beta.
//
// A contact lasts about sqrt(kLasting dt): as dt shrinks, contacts get shorter but take more steps;
// with a fixed number of steps the error of restitution would not vanish. Corners sink in, and
// friction creeps at rest.
#pragma once

#include <algorithm>

#include "scheme.hpp"

namespace bounce::study {

// The damping ratio zeta. For epsilon below e^-2 it is 1, because a larger one would need a shorter
// step.
inline double damping_ratio(double epsilon) {
  const double target = -std::log(std::max(epsilon, std::exp(-2.0))) / 2;  // beta cot beta
  if (target >= 1) return 1;
  const double most = std::acos(0.0);
  double beta = std::min(most, std::sqrt(3 * (1 - target)));
  for (int i = 0; i < 6; ++i) {  // Newton's method, from above a concave curve
    const double sine = std::sin(beta), cotangent = std::cos(beta) / sine;
    beta = std::min(most, beta - (beta * cotangent - target) / (cotangent - beta / (sine * sine)));
  }
  return std::cos(beta);
}

class Penalty : public StepConstants {
 public:
  static constexpr double kLasting = 0.25;  // s; with dt = 0.01 s a contact has 5 steps

  explicit Penalty(const Parameters& params) : StepConstants(params) {
    const double frequency = std::acos(-1.0) / std::sqrt(kLasting * params.dt);
    stiffness_ = frequency * frequency;
    damping_ = 2 * damping_ratio(params.epsilon) * frequency;
    friction_ = 1 / (4 * params.dt);  // c friction_ dt < 2 is stable; c is 2.5 at most
  }

  void step(Motion<double>& s) const {
    if (s.y < rho) press(s);
    s.v_x += dv_x;
    s.v_y += dv_y;
    move(s, dt);
  }

 private:
  void press(Motion<double>& s) const {
    const Motion<double> before = s;
    const auto r = arms(half, std::cos(s.theta), std::sin(s.theta));
    const auto touches = [&](const Arm<double>& arm) { return before.y + arm.y < 0; };
    double count = 0, sum = 0;  // of the corners that touch, and of their r_x
    for (const Arm<double>& arm : r) {
      if (!touches(arm)) continue;
      ++count;
      sum += arm.x;
    }
    for (const Arm<double>& arm : r)
      if (touches(arm)) press(s, before, arm, count + arm.x * sum / gyration_squared);
  }

  // Corners that approach at different speeds may give any a, so it is at least that of a free
  // mass.
  void press(Motion<double>& s, const Motion<double>& before, const Arm<double>& r,
             double a) const {
    const double damping = damping_ / std::sqrt(std::max(a, 1.0));
    const double depth = -(before.y + r.y);
    const double f_n = std::max(0.0, stiffness_ * depth - damping * normal_velocity(before, r));
    const double most = mu * f_n;
    const double f_t = std::clamp(-friction_ * tangential_velocity(before, r), -most, most);
    apply_impulse(s, r, dt * f_n, dt * f_t, gyration_squared);
  }

  double stiffness_ = 0, damping_ = 0, friction_ = 0;  // 1/s^2, 1/s, 1/s
};

}  // namespace bounce::study
