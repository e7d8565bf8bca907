#include "catalog.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <stdexcept>

#include "../methods/assignment_fast.hpp"
#include "../methods/moreau_jean.hpp"
#include "../methods/penalty.hpp"
#include "../methods/scheme.hpp"
#include "event_driven.hpp"

namespace bounce::study {
namespace {

// The assignment's delta for its dt: 0.001 m for 0.01 s.
constexpr double kDeltaSpeed = 0.1;  // m/s

long steps_between_samples(const Scene& scene, double dt, int samples) {
  return std::max(1L, std::lround(scene.until / samples / dt));
}

template <class Scheme>
Samples run_scheme(const Scene& scene, double dt, int samples, double delta_speed = 0) {
  Parameters params = scene.params;
  params.dt = fitting_step(scene, dt, samples);
  if (delta_speed > 0) params = methods::with_delta_per_dt(params, delta_speed);
  return methods::sample(Scheme(params, methods::motion_of<double>(scene.start)), samples,
                         steps_between_samples(scene, dt, samples));
}

// Bounces may end the sooner, the less exact the rest is.
EventOptions options_for(double tolerance) {
  EventOptions options;
  options.tolerance = tolerance;
  options.cut = std::max(options.cut, std::sqrt(tolerance));
  return options;
}

Samples run_events(const Scene& scene, int samples, const EventOptions& options) {
  return simulate_events<double>(scene.params, methods::motion_of<double>(scene.start),
                                 sample_times(scene, samples), options);
}

std::vector<double> steps() { return {1e-2, 3e-3, 1e-3, 3e-4, 1e-4, 3e-5, 1e-5}; }

}  // namespace

std::vector<double> sample_times(const Scene& scene, int samples) {
  std::vector<double> times;
  for (int i = 1; i <= samples; ++i) times.push_back(scene.until * i / samples);
  return times;
}

double fitting_step(const Scene& scene, double dt, int samples) {
  return scene.until / samples / double(steps_between_samples(scene, dt, samples));
}

Samples truth_of(const Scene& scene) { return truth_under(methods::ImpactLaw::newton, scene); }

Samples truth_under(methods::ImpactLaw law, const Scene& scene) {
  EventOptions options;
  options.law = law;
  options.tolerance = 1e-18;
  options.cut = 1e-8;
  std::vector<long double> times;
  times.reserve(kSamples);
  for (int i = 1; i <= kSamples; ++i) times.push_back((long double)(scene.until) * i / kSamples);
  const auto exact = simulate_events<long double>(
      scene.params, methods::motion_of<long double>(scene.start), times, options);
  if (exact.size() != kSamples)
    throw std::runtime_error(scene.name + ": the truth reached its cap on events");
  Samples samples;
  samples.reserve(exact.size());
  for (const auto& s : exact) {
    samples.push_back(
        {double(s.x), double(s.y), double(s.theta), double(s.v_x), double(s.v_y), double(s.omega)});
  }
  return samples;
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

double cpu_ns() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return double(time.tv_sec) * 1e9 + double(time.tv_nsec);
}

std::vector<Method> all_methods() {
  using methods::Motion;
  const Limit fixed_delta{"assignment_delta_dt", "delta stays while dt shrinks"},
      one_corner{"moreau_jean_2", "one corner takes what two should share"},
      another_law{"penalty", "its impacts come nearer to Stronge's law than to Newton's",
                  methods::ImpactLaw::stronge},
      coarse{"event_driven", "impacts are noticed up to a step too late"};
  return {
      {"assignment",
       "the assignment's scheme, plain",
       true,
       steps(),
       [](const Scene& s, double dt, int samples) {
         return run_scheme<methods::Assignment>(s, dt, samples);
       },
       {fixed_delta, one_corner}},
      {"assignment_fast",
       "the assignment's scheme, cos and sin carried",
       true,
       steps(),
       [](const Scene& s, double dt, int samples) {
         return run_scheme<methods::AssignmentFast>(s, dt, samples);
       },
       {fixed_delta, one_corner}},
      {"assignment_delta_dt",
       "the same with delta in proportion to dt",
       true,
       steps(),
       [](const Scene& s, double dt, int samples) {
         return run_scheme<methods::AssignmentFast>(s, dt, samples, kDeltaSpeed);
       },
       {one_corner}},
      {"moreau_jean_1",
       "Moreau-Jean, one corner",
       true,
       steps(),
       [](const Scene& s, double dt, int samples) {
         return run_scheme<methods::MoreauJean<1>>(s, dt, samples);
       },
       {one_corner}},
      {"moreau_jean_2",
       "Moreau-Jean, two corners",
       true,
       steps(),
       [](const Scene& s, double dt, int samples) {
         return run_scheme<methods::MoreauJean<2>>(s, dt, samples);
       },
       {coarse}},
      {"penalty",
       "springs and dampers",
       true,
       steps(),
       [](const Scene& s, double dt, int samples) {
         return run_scheme<methods::Penalty>(s, dt, samples);
       },
       {another_law}},
      {"event_driven",
       "event-driven",
       false,
       {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-8, 1e-10, 1e-12},
       [](const Scene& s, double tolerance, int samples) {
         return run_events(s, samples, options_for(tolerance));
       },
       {}},
  };
}

}  // namespace bounce::study
