#include "engine.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "../catalog.hpp"
#include "../timing.hpp"

namespace bounce::study {
namespace {

constexpr double kLargest = 1.0 / 30;  // s
constexpr double kClose = 1e-3;        // s; below, steps are two in a factor of ten

Motions samples_of(const Peer& peer, const Scene& scene, double dt, int samples) {
  const long steps = std::lround(scene.until / samples / dt);
  const auto engine = peer.make(scene, dt);
  Motion<double> before = motion_of(scene.start);
  Motions all;
  for (int i = 0; i < samples; ++i) {
    for (long n = 0; n < steps; ++n) engine->step();
    Motion<double> s = engine->motion();
    const double expected = before.theta + scene.until / samples * (before.omega + s.omega) / 2;
    const double turn = 2 * std::numbers::pi;
    s.theta += turn * std::round((expected - s.theta) / turn);
    all.push_back(s);
    before = s;
  }
  return all;
}

double time_of(const Peer& peer, const Scene& scene, double dt, long repeats) {
  double sum = 0;
  for (long i = 0; i < repeats; ++i) {
    const auto engine = peer.make(scene, dt);
    const long steps = std::lround(scene.until / dt);
    const double start = cpu_ns();
    for (long n = 0; n < steps; ++n) engine->step();
    sum += cpu_ns() - start;
  }
  return sum;
}

}  // namespace

Method method_of(const std::string& name, const Peer& peer, double least_dt) {
  const double least = std::max(least_dt, peer.least_dt);
  std::vector<double> steps = steps_down_to(std::max(least, kClose), kLargest);
  for (double dt = kClose / std::sqrt(10.0); dt > 0.99 * least; dt /= std::sqrt(10.0))
    steps.push_back(dt);
  return {name, true, steps,
          [peer](const Scene& scene, double dt, int samples) {
            return samples_of(peer, scene, dt, samples);
          },
          [peer](const Scene& scene, double dt, long repeats) {
            return time_of(peer, scene, dt, repeats);
          }};
}

}  // namespace bounce::study
