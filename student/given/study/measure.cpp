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

constexpr double kShare = 0.1;        // delta over dt where it is scaled, m/s
constexpr double kLongEnough = 1e-2;  // s of measuring
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Parameters with(Parameters params, double dt, Lift lift, Eigen::Index columns) {
  params.dt = dt;
  if (lift == Lift::scaled) params.delta = kShare * dt;
  params.T = static_cast<int>(columns);
  return params;
}

bool is_usable(const Trajectory& t, const Parameters& params) {
  return t.q.cols() == params.T && t.v.cols() == params.T && t.q.allFinite() && t.v.allFinite();
}

double distance(const Vector3& q, const Vector3& right, double l) {
  Vector3 apart = q - right;
  apart(2) *= l / std::numbers::sqrt2;  // the way of a corner
  return apart.norm();
}

double height_of_the_lowest_corner(const Vector3& q, double l) {
  const double turned = q(2) + std::numbers::pi / 4;
  return q(1) -
         l / std::numbers::sqrt2 * std::max(std::abs(std::cos(turned)), std::abs(std::sin(turned)));
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
Run run(const Scene& scene, double wanted, Lift lift, double one_lcp) {
  const double between = scene.truth.front().t;
  const auto n = static_cast<Eigen::Index>(std::max(1.0, std::round(between / wanted)));
  const auto samples = static_cast<Eigen::Index>(scene.truth.size());
  const double dt = between / static_cast<double>(n);
  const Parameters params = with(scene.params, dt, lift, n * samples + 1);
  const auto [q_0, v_0] = scene.start;
  Trajectory trajectory;
  const double took = seconds_of([&, q = q_0, v = v_0] { trajectory = simulate(q, v, params); });
  Run result{dt, kInfinity, took / scene.truth.back().t / one_lcp, 0};
  if (!is_usable(trajectory, params)) return result;
  result.error = 0;
  for (Eigen::Index k = 0; k < samples; ++k) {
    const Vector3& right = scene.truth[static_cast<std::size_t>(k)].q;
    result.error = std::max(result.error, distance(trajectory.q.col((k + 1) * n), right, params.l));
  }
  for (const auto& q : trajectory.q.colwise()) {
    result.depth = std::max(result.depth, -height_of_the_lowest_corner(q, params.l));
  }
  return result;
}

double energy_of(const Vector3& q, const Vector3& v, const Parameters& params) {
  return 0.5 * v.dot(params.M() * v) - q.dot(params.M() * params.g);
}

}  // namespace

std::vector<Run> runs(const Scene& scene, Lift lift, double one_lcp) {
  std::vector<Run> all;
  for (const double dt : {2e-2, 1e-2, 5e-3, 2e-3, 1e-3, 5e-4, 2e-4, 1e-4, 5e-5, 2e-5, 1e-5}) {
    all.push_back(run(scene, dt, lift, one_lcp));
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

Energy energy(const Scene& scene, double dt, double seconds) {
  const auto columns = static_cast<Eigen::Index>(std::round(seconds / dt)) + 1;
  const Parameters params = with(scene.params, dt, Lift::fixed, columns);
  const Trajectory trajectory = simulate(scene.start.q, scene.start.v, params);
  Energy result{{}, {}, 0, 0};
  if (!is_usable(trajectory, params)) return result;
  const double start = energy_of(scene.start.q, scene.start.v, params);
  result.lift = -params.m * params.g(1) * params.delta / start;
  for (Eigen::Index t = 0; t < columns; ++t) {
    result.t.push_back(static_cast<double>(t) * dt);
    result.share.push_back(energy_of(trajectory.q.col(t), trajectory.v.col(t), params) / start);
    if (t == 0) continue;
    const double gain = result.share.back() - result.share[result.share.size() - 2];
    result.largest_gain = std::max(result.largest_gain, gain);
  }
  return result;
}

Rest rest(const Parameters& scene, double dt, Lift lift) {
  const auto columns = static_cast<Eigen::Index>(std::round(10 / dt)) + 1;
  const Parameters params = with(scene, dt, lift, columns);
  const Vector3 q_0(0, params.l / 2, 0);
  const Trajectory trajectory = simulate(q_0, Vector3::Zero(), params);
  if (!is_usable(trajectory, params)) return {kInfinity, kInfinity};
  const Eigen::Matrix3Xd moved = (trajectory.q.colwise() - q_0).cwiseAbs();
  return {moved.row(1).maxCoeff(), moved.row(0).maxCoeff()};
}

}  // namespace bounce::study
