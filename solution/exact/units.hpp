// The units that an exact simulation works in, and its clock.
#pragma once

#include <algorithm>
#include <cmath>

#include "../methods/square.hpp"

namespace bounce::study {

// A time as the sum of two numbers, so that a short one is not lost beside the time since the
// start.
template <class Real>
class Clock {
 public:
  void advance(Real t) {
    const Real sum = high_ + t, added = sum - high_;
    low_ += (high_ - (sum - added)) + (t - added);
    high_ = sum;
  }
  Real until(Real t) const { return (t - high_) - low_; }

 private:
  Real high_ = 0, low_ = 0;
};

// The units of a scene: powers of two near l and sqrt(l / g), so that scaling rounds nothing. g has
// a lower bound here, which keeps the unit of time finite where gravity is almost zero.
struct Units {
  double length, time;

  template <class Real>
  Units(const Parameters& params, const Motion<Real>& start) {
    const double speed = std::max({std::abs(double(start.v_x)), std::abs(double(start.v_y)),
                                   params.l * std::abs(double(start.omega))});
    const double g = std::max(params.g.norm(), 1e-30 * speed * speed / params.l);
    length = power_near(params.l);
    time = g > 0 ? power_near(std::sqrt(params.l / g)) : 1;
  }

  template <class Real>
  Motion<Real> in(const Motion<Real>& s) const {
    const Real L = length, V = L / Real(time);
    return {s.x / L, s.y / L, s.theta, s.v_x / V, s.v_y / V, s.omega * Real(time)};
  }
  template <class Real>
  Motion<Real> out(const Motion<Real>& s) const {
    const Real L = length, V = L / Real(time);
    return {s.x * L, s.y * L, s.theta, s.v_x * V, s.v_y * V, s.omega / Real(time)};
  }
  Parameters in(Parameters params) const {
    params.l /= length;
    params.g *= time * (time / length);
    return params;
  }

 private:
  static double power_near(double x) { return std::exp2(std::round(std::log2(x))); }
};

}  // namespace bounce::study
