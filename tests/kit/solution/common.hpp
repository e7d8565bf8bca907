// Shared by the study's tests: random drops, the same on every machine, and the scenes' folder.
#pragma once

#include <vector>

#include "exact/scene.hpp"
#include "methods/square.hpp"
#include "study/random_scenes.hpp"

namespace bounce::exact::tests {

using namespace study;

struct Drop {
  Parameters params;
  methods::Motion<double> start;
};

// A square above the ground or touching it, whatever its angle; a fifth of them lie parallel to the
// ground, and a seventh have no friction. Gravity is tilted.
inline Drop random_drop(Random& random, int i, double largest_epsilon) {
  Drop drop;
  Parameters& params = drop.params;
  params.l = random.uniform(0.1, 1);
  params.m = random.uniform(0.1, 5);
  params.mu = i % 7 == 0 ? 0 : random.uniform(0, 1.2);
  params.epsilon = random.uniform(0, largest_epsilon);
  params.g = Vector3(random.uniform(-2, 2), -random.uniform(5, 15), 0);
  drop.start = {0,
                random.uniform(0.8, 2) * params.l,
                random.uniform(-4, 4),
                random.uniform(-3, 3),
                random.uniform(-3, 1),
                random.uniform(-10, 10)};
  if (i % 5 == 0) drop.start.theta = drop.start.omega = 0;
  return drop;
}

template <class Real>
std::vector<Real> even_times(Real until, int count) {
  std::vector<Real> times;
  for (int i = 1; i <= count; ++i) times.push_back(until * Real(i) / Real(count));
  return times;
}

inline std::vector<Scene> scenes() { return read_scenes(BOUNCE_SCENES); }

inline Scene scene_named(const std::string& name) {
  return read_scene(std::string(BOUNCE_SCENES) + "/" + name + ".json");
}

}  // namespace bounce::exact::tests
