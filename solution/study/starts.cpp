#include "starts.hpp"

#include <algorithm>
#include <cmath>

namespace bounce::study {
namespace {

// The scene as it is `time` later.
Scene later(const Scene& scene, double time) {
  if (time == 0) return scene;
  Scene until = scene, moved = scene;
  until.until = time;
  moved.start = methods::state_of(truth_of(until, 1).front());
  return moved;
}

}  // namespace

Grid grid_of(const Scene& scene, double dt) {
  const long steps = std::max(1L, std::lround(scene.until / dt));
  if (steps < kSamples) return {scene.until / double(steps), int(steps)};
  const auto off = [&](int samples) {
    return std::abs(steps - samples * std::lround(double(steps) / samples));
  };
  int samples = kSamples;
  for (int other = kSamples; other < 2 * kSamples; ++other)
    if (off(other) < off(samples)) samples = other;
  return {fitting_step(scene, dt, samples), samples};
}

Starts::Starts(const Scene& scene, double dt) : grid_(grid_of(scene, dt)) {
  for (int i = 0; i < kStarts; ++i) {
    scenes_.push_back(later(scene, grid_.dt * i / kStarts));
    truths_.push_back(truth_of(scenes_.back(), grid_.samples));
  }
}

Errors Starts::errors_of(const Run& run) const {
  std::vector<double> errors;
  double squares = 0;
  for (std::size_t i = 0; i < scenes_.size(); ++i) {
    errors.push_back(error_of(scenes_[i], run(scenes_[i], grid_), truths_[i]));
    squares += errors.back() * errors.back();
  }
  return {errors.front(), std::sqrt(squares / double(errors.size()))};
}

std::vector<double> steps_down_to(double least, double largest) {
  std::vector<double> steps;
  for (int i = 0;; ++i) {
    const double dt = largest * std::pow(10.0, -double(i) / kStepsPerDecade);
    if (dt < 0.99 * least) return steps;
    steps.push_back(dt);
  }
}

}  // namespace bounce::study
