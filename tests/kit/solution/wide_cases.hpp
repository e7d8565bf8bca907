// Random cases at every scale that parameters may have: l from 1e-6 to 1e4 m, gravity from 1e-3 to
// 1e5 m/s^2 and tilted, theta to 1e9 rad, mu to 10, epsilon from 0 to 1, every law of impact.
#pragma once

#include <cmath>
#include <cstdlib>
#include <string>

#include "common.hpp"
#include "exact/event_driven.hpp"

namespace bounce::exact::tests {

// How many random cases a test looks at: `usual`, or what BOUNCE_RANDOM_CASES says.
inline int random_cases(int usual) {
  const char* said = std::getenv("BOUNCE_RANDOM_CASES");
  return said ? std::atoi(said) : usual;
}

struct WideCase {
  Parameters params;
  methods::Motion<double> start;
  methods::ImpactLaw law;
  double until;  // s

  double unit_time() const { return std::sqrt(params.l / params.g.norm()); }
  double unit_speed() const { return std::sqrt(params.l * params.g.norm()); }
};

inline double wide_mu(Random& random) {
  const double kind = random.uniform(0, 1);
  return kind < 0.1 ? 0 : random.uniform(0, kind < 0.5 ? 1 : 10);
}

// Down in half of the cases; else tilted up to where the square would fall along the ground, and
// seldom upward.
inline Vector3 wide_gravity(Random& random) {
  const double g = log_uniform(random, 1e-3, 1e5), kind = random.uniform(0, 1);
  const double tilt = kind < 0.5    ? 0
                      : kind < 0.95 ? random.uniform(-1.5, 1.5)
                                    : random.uniform(-3.2, 3.2);
  return {g * std::sin(tilt), -g * std::cos(tilt), 0};
}

inline double wide_angle(Random& random) {
  const double kind = random.uniform(0, 1);
  if (kind < 0.15) return 0;
  if (kind < 0.3) return either_sign(random) * log_uniform(random, 1e-12, 1);
  if (kind < 0.7) return random.uniform(-4, 4);
  return either_sign(random) * log_uniform(random, 1, 1e9);
}

// A velocity in units of the case: of its scale, or of a size between far too small and far too
// large for it, or none.
inline double wide_velocity(Random& random) {
  const double kind = random.uniform(0, 1);
  if (kind < 0.2) return 0;
  if (kind < 0.6) return random.uniform(-3, 3);
  return either_sign(random) * log_uniform(random, 1e-9, 1e3);
}

// The square stands on the ground in a third of the cases, and in the others falls from up to
// 1e4 l.
inline WideCase wide_case(Random& random, int i) {
  WideCase c;
  Parameters& params = c.params;
  params.l = log_uniform(random, 1e-6, 1e4);
  params.m = log_uniform(random, 1e-6, 1e6);
  params.mu = wide_mu(random);
  params.epsilon = any_epsilon(random);
  params.g = wide_gravity(random);
  c.law = methods::ImpactLaw(i % 3);
  const double theta = wide_angle(random);
  const double half = params.l / 2;
  const double height = half * (std::abs(std::cos(theta)) + std::abs(std::sin(theta)));
  const double lifted = chance(random, 1.0 / 3) ? 0 : params.l * log_uniform(random, 1e-9, 1e4);
  const double speed = c.unit_speed();
  c.start = {chance(random, 0.5) ? 0 : params.l * random.uniform(-100, 100),
             height + lifted,
             theta,
             speed * wide_velocity(random),
             speed * wide_velocity(random),
             speed / params.l * wide_velocity(random)};
  const double fall = std::sqrt(2 * lifted / params.g.norm());
  c.until = 2 * fall + c.unit_time() * log_uniform(random, 0.1, 100);
  return c;
}

// How far rounding alone can sink a corner, m: that of y, of theta and of the time; and what counts
// as touching.
inline double rounding_depth(const WideCase& c, const methods::Motion<double>& s, double t) {
  const double corner_speed = std::abs(s.v_y) + c.params.l * std::abs(s.omega);
  return 1e-13 * c.params.l +
         0x1p-48 * (std::abs(s.y) + c.params.l * (1 + std::abs(s.theta)) + t * corner_speed);
}

}  // namespace bounce::exact::tests
