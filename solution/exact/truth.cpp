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
  EventOptions options;
  options.tolerance = 1e-18;
  options.cut = 1e-8;
  std::vector<long double> times;
  for (int i = 1; i <= samples; ++i) times.push_back((long double)(scene.until) * i / samples);
  Samples truth = in_long_double(scene, times, options);
  if (truth.size() != std::size_t(samples))
    throw std::runtime_error(scene.name + ": the truth stalled: events go on without an end");
  return truth;
}

Samples in_long_double(const Scene& scene, const std::vector<long double>& times,
                       const EventOptions& options, EventReport* report) {
  Samples rounded;
  for (const auto& s : simulate_events<long double>(
           scene.params, methods::motion_of<long double>(scene.start), times, options, report)) {
    rounded.push_back(
        {double(s.x), double(s.y), double(s.theta), double(s.v_x), double(s.v_y), double(s.omega)});
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
