#include "catalog.hpp"

#include <algorithm>
#include <cmath>

#include "../exact/event_driven.hpp"
#include "../methods/assignment.hpp"
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
                         std::lround(scene.until / samples / params.dt));
}

// The less exact the rest is, the sooner bounces may end.
EventOptions options_for(double tolerance) {
  return {.cut = std::max(EventOptions().cut, std::sqrt(tolerance)), .tolerance = tolerance};
}

Samples run_events(const Scene& scene, int samples, const EventOptions& options) {
  return simulate_events<double>(scene.params, methods::motion_of<double>(scene.start),
                                 sample_times(scene, samples), options);
}

template <class Scheme>
Method stepping(const char* name, double delta_speed = 0) {
  return {name, true, steps_down_to(1e-5), [delta_speed](const Scene& s, double dt, int samples) {
            return run_scheme<Scheme>(s, dt, samples, delta_speed);
          }};
}

}  // namespace

Setting measure(const Method& method, double setting, StartsOfScene& starts) {
  const Starts& own = starts.at(method.has_step ? setting : kLargestStep);
  const double value = method.has_step ? own.grid().dt : setting;
  return {value, own.grid().samples, own.errors_of([&](const Scene& scene, const Grid& grid) {
            return method.simulate(scene, value, grid.samples);
          })};
}

Methods all_methods() {
  return {stepping<methods::Assignment>("assignment"),
          stepping<methods::Assignment>("assignment_delta_dt", kDeltaSpeed),
          stepping<methods::MoreauJean<1>>("moreau_jean_1"),
          stepping<methods::MoreauJean<2>>("moreau_jean_2"),
          stepping<methods::Penalty>("penalty"),
          {"event_driven",
           false,
           {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-8, 1e-10, 1e-12},
           [](const Scene& s, double tolerance, int samples) {
             return run_events(s, samples, options_for(tolerance));
           }}};
}

}  // namespace bounce::study
