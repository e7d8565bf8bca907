#include <algorithm>
#include <bounce/part3_step.hpp>

#include "measure.hpp"

namespace bounce::study {
namespace {

constexpr int kLandings = 4;  // that are found within a step
constexpr int kHalvings = 45;
constexpr double kNoTime = 1e-9, kNoDelta = 1e-6;  // of dt and of delta, in place of none
constexpr double kClear = 1e-12;  // m: so deep no rounding hides a contact from your step

// The causes that a run is left with.
struct Left {
  bool flight = false, impact = false, delta = false;
};

bool touches(const State& s, const Parameters& params) {
  return lowest_heights(s.q, params.l)[0] < params.delta - kClear;
}

// Your step, as long as `dt`. To fly without error it begins with the velocity of half a step
// before, so that v' is the mean velocity of the step.
State moved(const State& s, Parameters params, double dt, Left left) {
  params.dt = dt;
  const Vector3 half = (left.flight || touches(s, params) ? 0 : dt / 2) * params.g;
  const State next = step(s.q, s.v - half, params);
  return {next.q, next.v + half};
}

// Your step; unless impacts are late, in pieces: up to the landing, the impact in no time, the
// rest.
State moved(State s, const Parameters& params, Left left) {
  double rest = params.dt;
  const auto lands = [&](double dt) { return touches(moved(s, params, dt, left), params); };
  for (int i = 0; i < kLandings && !left.impact && !touches(s, params) && lands(rest); ++i) {
    double before = 0, after = rest;
    for (int k = 0; k < kHalvings; ++k) {
      const double middle = (before + after) / 2;
      (lands(middle) ? after : before) = middle;
    }
    s = moved(moved(s, params, after, left), params, kNoTime * rest, left);
    rest -= after;
  }
  return moved(s, params, rest, left);
}

// Where the square is at each sample of the truth.
std::vector<Vector3> path(const Scene& scene, double dt, Left left) {
  auto [params, n] = fit(scene, dt, Lift::fixed);
  if (!left.delta) params.delta *= kNoDelta;
  std::vector<Vector3> places;
  for (State s = scene.start; places.size() < scene.truth.size(); places.push_back(s.q)) {
    for (Eigen::Index i = 0; i < n; ++i) s = moved(s, params, left);
  }
  return places;
}

}  // namespace

std::array<double, 4> causes(const Scene& scene, double dt) {
  const double l = scene.params.l;
  const auto none = path(scene, dt, {});
  return {farthest(path(scene, dt, {true, false, false}), none, l),
          farthest(path(scene, dt, {false, true, false}), none, l),
          farthest(path(scene, dt, {false, false, true}), none, l), farthest(none, scene.truth, l)};
}

}  // namespace bounce::study
