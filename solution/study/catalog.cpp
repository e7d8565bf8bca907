#include "catalog.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>

#include "../exact/event_driven.hpp"
#include "../methods/assignment_fast.hpp"
#include "../methods/moreau_jean.hpp"
#include "../methods/penalty.hpp"
#include "../methods/scheme.hpp"

namespace bounce::study {
namespace {

// The assignment's delta for its dt: 0.001 m for 0.01 s.
constexpr double kDeltaSpeed = 0.1;  // m/s
// Whose parts the starts of a method without steps lie apart.
constexpr double kLargestStep = 0.01;  // s

template <class Scheme>
Samples run_scheme(const Scene& scene, double dt, int samples, double delta_speed = 0) {
  Parameters params = scene.params;
  params.dt = fitting_step(scene, dt, samples);
  if (delta_speed > 0) params = methods::with_delta_per_dt(params, delta_speed);
  return methods::sample(Scheme(params, methods::motion_of<double>(scene.start)), samples,
                         steps_between_samples(scene, dt, samples));
}

// The less exact the rest is, the sooner bounces may end.
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

std::vector<double> steps() { return steps_down_to(1e-5); }

}  // namespace

Setting measure(const Method& method, double setting, StartsOfScene& starts) {
  const Starts& own = starts.at(method.has_step ? setting : kLargestStep);
  const double value = method.has_step ? own.grid().dt : setting;
  return {value, own.grid().samples, own.errors_of([&](const Scene& scene, const Grid& grid) {
            return method.simulate(scene, value, grid.samples);
          })};
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
      springs{"event_driven", "springs are another law for two corners at once"},
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
       {another_law, springs}},
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
