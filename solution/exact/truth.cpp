#include "truth.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace bounce::exact {

std::vector<double> sample_times(const Scene& scene, int samples) {
  std::vector<double> times;
  for (int i = 1; i <= samples; ++i) times.push_back(scene.until * i / samples);
  return times;
}

double fitting_step(const Scene& scene, double dt, int samples) {
  const double apart = scene.until / samples;
  return apart / double(std::max(1L, std::lround(apart / dt)));
}

Samples truth_of(const Scene& scene, int samples) {
  std::vector<long double> times;
  for (int i = 1; i <= samples; ++i) times.push_back((long double)(scene.until) * i / samples);
  Samples truth = in_long_double(scene, times, {.cut = 1e-8, .tolerance = 1e-18});
  if (truth.size() != std::size_t(samples))
    throw std::runtime_error(scene.name + ": the truth stalled: events go on without an end");
  return truth;
}

Samples second_truth(const Scene& scene, const std::vector<double>& times) {
  return in_long_double(scene, {times.begin(), times.end()},
                        {.cut = 3e-8, .tolerance = 1e-19, .touching = 0, .noise = 0x1p-62});
}

Samples in_long_double(const Scene& scene, const std::vector<long double>& times,
                       const EventOptions& options, EventReport* report) {
  Samples rounded;
  for (const auto& s : simulate_events<long double>(
           scene.params, methods::motion_of<long double>(scene.start), times, options, report)) {
    rounded.push_back(methods::motion_of<double>(methods::state_of(s)));
  }
  return rounded;
}

double error_of(const Scene& scene, const Samples& samples, const Samples& truth) {
  if (samples.size() != truth.size()) return std::numeric_limits<double>::infinity();
  double worst = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double error = distance(scene, samples[i], truth[i]);
    if (!(error <= worst))
      worst = std::isnan(error) ? std::numeric_limits<double>::infinity() : error;
  }
  return worst;
}

}  // namespace bounce::exact
