#include "catalog.hpp"

#include <algorithm>
#include <cmath>

#include "../exact/simulate_scene.hpp"
#include "../methods/assignment.hpp"
#include "../methods/moreau_jean.hpp"
#include "../methods/penalty.hpp"

namespace bounce::study {
namespace {

// The assignment's delta for its dt: 0.001 m for 0.01 s.
constexpr double kDeltaSpeed = 0.1;  // m/s
constexpr int kStepsPerDecade = 4;

template <class Scheme>
Method stepping(const char* name, double delta_speed = 0) {
  return {name, true, steps_down_to(1e-5), [=](const Scene& scene, double dt, int samples) {
            Parameters params = scene.params;
            params.dt = fitting_step(scene, dt, samples);
            if (delta_speed > 0) params.delta = delta_speed * params.dt;
            return sample(Scheme(params), motion_of(scene.start), samples,
                          std::lround(scene.until / samples / params.dt));
          }};
}

// The less exact the rest is, the sooner bounces may end.
Motions run_events(const Scene& scene, double tolerance, int samples) {
  const double cut = std::max(EventOptions().cut, std::sqrt(tolerance));
  return simulate_events<double>(scene.params, motion_of(scene.start),
                                 even_times(scene.until, samples),
                                 {.cut = cut, .tolerance = tolerance});
}

}  // namespace

Methods all_methods() {
  return {stepping<Assignment>("assignment"),
          stepping<Assignment>("assignment_delta_dt", kDeltaSpeed),
          stepping<MoreauJean<1>>("moreau_jean_1"),
          stepping<MoreauJean<2>>("moreau_jean_2"),
          stepping<Penalty>("penalty"),
          {"event_driven", false, {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-8, 1e-10, 1e-12}, run_events}};
}

std::vector<double> steps_down_to(double least, double largest) {
  std::vector<double> steps;
  for (int i = 0;; ++i) {
    const double dt = largest * std::pow(10.0, -double(i) / kStepsPerDecade);
    if (dt < 0.99 * least) return steps;
    steps.push_back(dt);
  }
}

Model model_of(ModelLevel level) {
  const int corners = level <= ModelLevel::ballistic      ? 0
                      : level <= ModelLevel::one_friction ? 1
                                                          : 2;
  return {corners, level == ModelLevel::one_friction || level == ModelLevel::two_frictions};
}

Motions motion_with(const Scene& scene, ModelLevel level, const std::vector<double>& times,
                    EventOptions options) {
  const auto start = motion_of(scene.start);
  if (level == ModelLevel::asleep) return {times.size(), start};
  options.model = model_of(level);
  return simulate_events<double>(scene.params, start, times, options);
}

Parameters stepped(const Scene& scene, double dt) {
  Parameters params = scene.params;
  params.dt = dt;
  params.T = int(std::lround(scene.until / dt)) + 1;
  return params;
}

Motions whole_model(const Parameters& params, const State& start) {
  return sample(MoreauJean<2>(params), motion_of(start), params.T - 1, 1);
}

double distance_to_whole_model(const Parameters& params, const State& start) {
  const Trajectory chosen = simulate_scene(params, start);
  double farthest = 0;
  Eigen::Index column = 0;
  for (const auto& s : whole_model(params, start)) {
    const Vector3 off = chosen.q.col(++column) - state_of(s).q;
    farthest = std::max(farthest, off.cwiseAbs().maxCoeff());
  }
  return farthest;
}

}  // namespace bounce::study
