// Random changes of a motion, as rounding makes them.
#pragma once

#include <cmath>
#include <numbers>
#include <random>

#include "../methods/square.hpp"

namespace bounce::study {

// Numbers of either sign between size / 2 and size, at random. Their sizes differ, so that two of
// them cancel rarely, which size and -size alone would do half of the time.
class Noise {
 public:
  Noise(double size, unsigned seed) : size_(size), random_(seed) {}

  double next() {
    const double u = 2 * double(random_()) / double(random_.max()) - 1;  // from -1 to 1
    return size_ * (u + std::copysign(1.0, u)) / 2;
  }

 private:
  double size_;
  std::minstd_rand random_;
};

// Changes the motion after `time` without an event as much as rounding of the noise's size could. A
// square that is exactly parallel to the ground and does not turn stays so. Units are the body's:
// its size and g are near 1.
template <class Real>
void disturb(Motion<Real>& s, const Body<Real>& body, Real time, Noise& noise) {
  const Real quarter = std::numbers::pi_v<Real> / 2;
  const Real tilt = s.theta - std::round(s.theta / quarter) * quarter;
  const Real speed = std::abs(s.v_x) + std::abs(s.v_y) + body.rho * std::abs(s.omega) + time;
  s.x += Real(noise.next()) * (1 + time * std::abs(s.v_x));
  s.v_x += Real(noise.next()) * speed;
  s.v_y += Real(noise.next()) * speed;
  if (tilt == 0 && s.omega == 0) return;
  s.theta += Real(noise.next()) * (std::abs(tilt) + time * std::abs(s.omega));
  s.omega += Real(noise.next()) * speed;
}

}  // namespace bounce::study
