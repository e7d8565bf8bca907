// Random cases, the same on every machine, and the scenes' folder.
#pragma once

#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "exact/truth.hpp"
#include "study/random_scenes.hpp"

namespace bounce::study::tests {

// How many random cases a test looks at: `usual`, or what BOUNCE_RANDOM_CASES says.
inline int random_cases(int usual) {
  const char* asked = std::getenv("BOUNCE_RANDOM_CASES");
  return asked ? std::atoi(asked) : usual;
}

struct Case {
  Parameters params;
  Motion<double> start;
  double until = 1;  // s

  double unit_time() const { return std::sqrt(params.l / params.g.norm()); }
  double unit_speed() const { return std::sqrt(params.l * params.g.norm()); }
};

// A square of ordinary size above the ground, whatever its angle; a fifth of
// them lie parallel to the ground, a seventh have no friction, a third spin fast. Gravity is
// tilted.
inline Case ordinary_case(Random& random, int i, double largest_epsilon) {
  Case c;
  Parameters& params = c.params;
  params.l = random.uniform(0.1, 1);
  params.m = random.uniform(0.1, 5);
  params.mu = i % 7 == 0 ? 0 : random.uniform(0, 1.2);
  params.epsilon = random.uniform(0, largest_epsilon);
  params.g = Vector3(random.uniform(-2, 2), -random.uniform(5, 15), 0);
  c.start = {0,
             random.uniform(0.8, 2) * params.l,
             random.uniform(-4, 4),
             random.uniform(-3, 3),
             random.uniform(-3, 1),
             random.uniform(-10, 10) * (i % 3 == 0 ? 5 : 1)};
  if (i % 5 == 0) c.start.theta = c.start.omega = 0;
  return c;
}

// A drop on a steep slope, on which a square rocks until it lies.
inline Case rocking_case(Random& random, int) {
  Case c;
  c.params.l = 0.2;
  c.params.mu = random.uniform(0.3, 1.2);
  c.params.epsilon = random.uniform(0, 0.9);
  const double tilt = random.uniform(0.3, 0.78);
  c.params.g = Vector3(9.81 * std::sin(tilt), -9.81 * std::cos(tilt), 0);
  const double theta = either_sign(random) * log_uniform(random, 1e-6, 1e-2);
  const double height = height_on_ground(c.params.l / 2, theta) + log_uniform(random, 1e-9, 1e-2);
  c.start = {0, height, theta, random.uniform(-1, 1), 0, 0};
  c.until = 5;
  return c;
}

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

// In units of the case: of its scale, or far too small or too large for it, or none.
inline double wide_velocity(Random& random) {
  const double kind = random.uniform(0, 1);
  if (kind < 0.2) return 0;
  if (kind < 0.6) return random.uniform(-3, 3);
  return either_sign(random) * log_uniform(random, 1e-9, 1e3);
}

// At every scale: l from 1e-6 to 1e4 m, gravity from 1e-3 to 1e5 m/s^2 and tilted, theta to 1e9
// rad, mu to 10, epsilon from 0 to 1. A third stand on the ground, as far as rounding
// says, and the others fall from up to 1e4 l.
inline Case wide_case(Random& random, int) {
  Case c;
  Parameters& params = c.params;
  params.l = log_uniform(random, 1e-6, 1e4);
  params.m = log_uniform(random, 1e-6, 1e6);
  params.mu = wide_mu(random);
  params.epsilon = any_epsilon(random);
  params.g = wide_gravity(random);
  const double theta = wide_angle(random);
  const double lifted = chance(random, 1.0 / 3) ? 0 : params.l * log_uniform(random, 1e-9, 1e4);
  const double speed = c.unit_speed();
  c.start = {chance(random, 0.5) ? 0 : params.l * random.uniform(-100, 100),
             height_on_ground(params.l / 2, theta) + lifted,
             theta,
             speed * wide_velocity(random),
             speed * wide_velocity(random),
             speed / params.l * wide_velocity(random)};
  const double fall = std::sqrt(2 * lifted / params.g.norm());
  c.until = 2 * fall + c.unit_time() * log_uniform(random, 0.1, 100);
  return c;
}

inline Scenes scenes() { return read_scenes(BOUNCE_SCENES); }

inline Scene scene_named(const std::string& name) {
  return read_scene(std::filesystem::path(BOUNCE_SCENES) / (name + ".json"));
}

}  // namespace bounce::study::tests
