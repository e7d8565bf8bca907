#include "truth.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace bounce::study {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

double fitting_step(const Scene& scene, double dt, int samples) {
  const double apart = scene.until / samples;
  return apart / double(std::max(1L, std::lround(apart / dt)));
}

Motions truth_of(const Scene& scene, int samples) {
  Motions truth = in_long_double(scene, even_times<long double>(scene.until, samples),
                                 {.cut = 1e-8, .tolerance = 1e-18});
  if (truth.size() != std::size_t(samples))
    throw std::runtime_error(scene.name + ": the truth stalled: events go on without an end");
  return truth;
}

Motions second_truth(const Scene& scene, const std::vector<double>& times) {
  return in_long_double(scene, {times.begin(), times.end()},
                        {.cut = 3e-8, .tolerance = 1e-19, .touching = 0, .noise = 0x1p-62});
}

Motions in_long_double(const Scene& scene, const std::vector<long double>& times,
                       const EventOptions& options, EventReport* report) {
  Motions rounded;
  for (const auto& s : simulate_events<long double>(
           scene.params, motion_of<long double>(scene.start), times, options, report)) {
    rounded.push_back(motion_of(state_of(s)));
  }
  return rounded;
}

std::vector<double> farthest(const Scene& scene, const Motions& one, const Motions& other) {
  std::vector<double> far(std::min(one.size(), other.size()));
  double worst = 0;
  for (std::size_t i = 0; i < far.size(); ++i) {
    const double apart = distance(scene, one[i], other[i]);
    if (!(apart <= worst)) worst = std::isnan(apart) ? kInfinity : apart;
    far[i] = worst;
  }
  return far;
}

double error_of(const Scene& scene, const Motions& samples, const Motions& truth) {
  if (samples.size() != truth.size()) return kInfinity;
  return samples.empty() ? 0 : farthest(scene, samples, truth).back();
}

}  // namespace bounce::study
