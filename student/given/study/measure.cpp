#include "measure.hpp"

#include <algorithm>
#include <bounce/part4_simulate.hpp>
#include <bounce/solve_lcp.hpp>
#include <cmath>
#include <ctime>
#include <limits>
#include <numbers>

namespace bounce::study {
namespace {

constexpr double kLongEnough = 1e-2;  // s of measuring
constexpr double kInfinity = std::numeric_limits<double>::infinity();

bool is_usable(const Trajectory& t, const Parameters& params) {
  return t.q.cols() == params.T && t.v.cols() == params.T && t.q.allFinite() && t.v.allFinite();
}

// CPU time of one call, in the mean: what else the machine does makes little difference.
template <class Act>
double seconds_of(const Act& act) {
  const std::clock_t start = std::clock();
  double all = 0;
  int calls = 0;
  for (; all < kLongEnough; ++calls) {
    act();
    all = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  }
  return all / calls;
}

// The step is fitted so that a whole number of them makes up the time between two samples.
Run run(const Scene& scene, double wanted, Lift lift) {
  const double between = scene.truth[0][0];
  const auto n = static_cast<Eigen::Index>(std::max(1.0, std::round(between / wanted)));
  const auto samples = static_cast<Eigen::Index>(scene.truth.size());
  Parameters params = scene.params;
  params.dt = between / static_cast<double>(n);
  if (lift == Lift::scaled) params.delta = kShare * params.dt;
  params.T = static_cast<int>(n * samples + 1);
  const auto [q, v] = scene.start;
  Trajectory trajectory;
  const double took = seconds_of([&, q = q, v = v] { trajectory = simulate(q, v, params); });
  Run result{params.dt, kInfinity, took / scene.truth.back()[0].get<double>()};
  if (!is_usable(trajectory, params)) return result;
  result.error = 0;
  for (Eigen::Index k = 0; k < samples; ++k) {
    const json& row = scene.truth[static_cast<std::size_t>(k)];
    const Vector3 right(row[1].get<double>(), row[2].get<double>(), row[3].get<double>());
    Vector3 apart = trajectory.q.col((k + 1) * n) - right;
    apart(2) *= params.l / std::numbers::sqrt2;  // the way of a corner
    result.error = std::max(result.error, apart.norm());
  }
  return result;
}

}  // namespace

std::vector<Run> runs(const Scene& scene, Lift lift) {
  std::vector<Run> all;
  for (const double dt : {2e-2, 1e-2, 5e-3, 2e-3, 1e-3, 5e-4, 2e-4, 1e-4, 5e-5, 2e-5, 1e-5}) {
    all.push_back(run(scene, dt, lift));
  }
  return all;
}

double lcp_seconds() {
  Eigen::Matrix4d V;
  V << 0.0551012, 0.0412668, -0.0412668, 0, 0.0412668, 0.111565, -0.111565, 1, -0.0412668,
      -0.111565, 0.111565, 1, 0.3, -1, -1, 0;
  const Eigen::Vector4d p(-1.79604, -3.25017, 3.25017, 0);
  constexpr int kCalls = 1000;
  volatile double kept = 0;  // so that the calls aren't left out
  return seconds_of([&] {
           for (int i = 0; i < kCalls; ++i) kept = solve_lcp(V, p)(0);
         }) /
         kCalls;
}

std::array<int, 3> touches(const Scene& scene, double dt) {
  std::array<int, 3> counts{};
  const auto moved = motion(scene.start, scene.params, dt, scene.truth.back()[0]);
  for (Eigen::Index t = 0; moved && t + 1 < moved->q.cols(); ++t) {
    const auto [lowest, second] = lowest_heights(moved->q.col(t), scene.params.l);
    ++counts[(lowest < scene.params.delta) + (second < scene.params.delta)];
  }
  return counts;
}

std::optional<Trajectory> motion(const State& start, Parameters params, double dt, double seconds) {
  params.dt = dt;
  params.T = static_cast<int>(std::round(seconds / dt)) + 1;
  Trajectory trajectory = simulate(start.q, start.v, params);
  if (!is_usable(trajectory, params)) return {};
  return trajectory;
}

std::array<double, 2> lowest_heights(const Vector3& q, double l) {
  const double turned = q(2) + std::numbers::pi / 4, reach = l / std::numbers::sqrt2;
  const auto [less, more] = std::minmax({std::abs(std::sin(turned)), std::abs(std::cos(turned))});
  return {q(1) - reach * more, q(1) - reach * less};
}

}  // namespace bounce::study
