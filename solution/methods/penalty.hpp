// A spring and a damper at every corner that is below the ground (Cundall & Strack 1979, "A
// discrete numerical model for granular assemblies", Geotechnique 29), per unit of mass:
//
//     f_n = max(0, -stiffness phi - damping v_n),   f_t = -v_t damping_t within +-mu f_n,
//
// and semi-implicit Euler. A point mass on such a spring bounces with restitution epsilon where
// damping = 2 zeta sqrt stiffness and zeta = -ln epsilon / sqrt(pi^2 + ln^2 epsilon). A contact
// lasts kStepsOfContact steps, stiffness = (pi / (kStepsOfContact dt))^2, so that the spring gets
// stiffer with dt. Corners sink in, pulling is cut off, and friction creeps at rest.
#pragma once

#include <algorithm>

#include "assignment.hpp"

namespace bounce::methods {

class Penalty {
 public:
  static constexpr double kStepsOfContact = 20;

  Penalty(const Parameters& params, const Motion<double>& start) : k_(params), s_(start) {
    const double pi = std::acos(-1.0), frequency = pi / (kStepsOfContact * params.dt);
    const double decrement = params.epsilon > 0 ? -std::log(params.epsilon) : 700;
    const double zeta = decrement / std::hypot(pi, decrement);
    stiffness_ = frequency * frequency;
    damping_ = 2 * zeta * frequency;
    friction_ = 1 / (4 * params.dt);  // c friction_ dt < 2 is stable; c is 2.5 at most
  }

  void steps(long n) {
    for (; n > 0; --n) step();
  }

  Motion<double> motion() const { return s_; }

 private:
  void step() {
    if (s_.y < k_.rho) press();
    s_.v_x += k_.dv_x;
    s_.v_y += k_.dv_y;
    move(s_, k_);
  }

  void press() {
    const Motion<double> before = s_;
    for (const Arm<double>& r : arms(k_.half, std::cos(s_.theta), std::sin(s_.theta))) {
      const double depth = -(before.y + r.y);
      if (!(depth > 0)) continue;
      const double f_n = std::max(0.0, stiffness_ * depth - damping_ * normal_velocity(before, r));
      const double most = k_.mu * f_n;
      const double f_t = std::clamp(-friction_ * sliding_velocity(before, r), -most, most);
      push(s_, r, k_.dt * f_n, k_.dt * f_t, k_.gyration);
    }
  }

  StepConstants k_;
  Motion<double> s_;
  double stiffness_ = 0, damping_ = 0, friction_ = 0;  // 1/s^2, 1/s, 1/s
};

}  // namespace bounce::methods
