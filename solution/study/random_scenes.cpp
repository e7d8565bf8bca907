#include "random_scenes.hpp"

#include <cmath>

namespace bounce::study {

double log_uniform(Random& random, double low, double high) {
  return std::exp(random.uniform(std::log(low), std::log(high)));
}

bool chance(Random& random, double p) { return random.uniform(0, 1) < p; }

double either_sign(Random& random) { return chance(random, 0.5) ? -1 : 1; }

double any_epsilon(Random& random) {
  const double kind = random.uniform(0, 1);
  return kind < 0.05 ? 0 : kind < 0.1 ? 1 : random.uniform(0, 1);
}

Scene random_scene(Random& random) {
  Scene scene{};
  Parameters& params = scene.params;
  params.l = log_uniform(random, 0.02, 5);
  params.m = log_uniform(random, 0.01, 100);
  params.mu = chance(random, 0.1) ? 0 : random.uniform(0, 1.3);
  params.epsilon = any_epsilon(random);
  const double tilt = chance(random, 0.5) ? 0 : random.uniform(-0.6, 0.6);
  params.g = Vector3(9.81 * std::sin(tilt), -9.81 * std::cos(tilt), 0);
  params.dt = log_uniform(random, 1e-3, 0.05);
  params.T = 2 + int(random.uniform(0, 60));
  const double kind = random.uniform(0, 1);
  const double theta = kind < 0.2 ? 0 : random.uniform(-4, 4);
  const double height = height_on_ground(params.l / 2, theta);
  const double lifted = chance(random, 0.15) ? 0 : params.l * log_uniform(random, 1e-4, 10);
  scene.start.q = Vector3(random.uniform(-1, 1), height + lifted, theta);
  scene.start.v = Vector3(random.uniform(-3, 3), random.uniform(-2, 2), random.uniform(-10, 10));
  if (kind < 0.15) scene.start.v.tail<2>().setZero();
  return scene;
}

}  // namespace bounce::study
