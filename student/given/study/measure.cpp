#include "measure.hpp"

#include <algorithm>
#include <bounce/part1_contacts.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>
#include <bounce/solve_lcp.hpp>
#include <cmath>
#include <ctime>
#include <limits>
#include <numbers>

#include "page.hpp"

namespace bounce::study {
namespace {

constexpr double kLongEnough = 2e-3;  // s of measuring
constexpr int kTimes = 5;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

bool is_usable(const Trajectory& t, const Parameters& params) {
  return t.q.cols() == params.T && t.v.cols() == params.T && t.q.allFinite() && t.v.allFinite();
}

// What simulate returns. Where solve_lcp refuses what a NaN of part 1 leads to, this says so.
Trajectory simulated(State s, const Parameters& params) try {
  return simulate(s.q, s.v, params);
} catch (const std::exception&) {
  for (int t = 0; t < params.T; ++t, s = step(s.q, s.v, params)) {  // which throws the same
    if (get_contacts(s.q, params).J.allFinite()) continue;
    throw std::runtime_error("part 1 returns NaN at y = " + number(s.q(1)) +
                             " m and theta = " + number(s.q(2)) + " rad");
  }
  throw;
}

// CPU time of one call, in the mean of some milliseconds, and the least of a few of these: what
// else the machine does only adds to it.
template <class Act>
double seconds_of(const Act& act) {
  double least = kInfinity;
  for (int i = 0; i < kTimes; ++i) {
    const std::clock_t start = std::clock();
    double all = 0;
    int calls = 0;
    for (; all < kLongEnough; ++calls) {
      act();
      all = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    }
    least = std::min(least, all / calls);
  }
  return least;
}

Run run(const Scene& scene, double wanted, Lift lift) {
  const auto [params, n] = fit(scene, wanted, lift);
  Trajectory trajectory;
  const double took = seconds_of([&, &p = params] { trajectory = simulated(scene.start, p); });
  Run result{params.dt, kInfinity, took / (params.dt * (params.T - 1))};
  if (!is_usable(trajectory, params)) return result;
  std::vector<Vector3> places;
  for (Eigen::Index t = n; t < params.T; t += n) places.push_back(trajectory.q.col(t));
  result.error = farthest(places, scene.truth, params.l);
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
  const auto moved = motion(scene.start, scene.params, dt,
                            scene.between * static_cast<double>(scene.truth.size()));
  for (Eigen::Index t = 0; moved && t + 1 < moved->q.cols(); ++t) {
    const auto [lowest, second] = lowest_heights(moved->q.col(t), scene.params.l);
    ++counts[(lowest < scene.params.delta) + (second < scene.params.delta)];
  }
  return counts;
}

Fitted fit(const Scene& scene, double dt, Lift lift) {
  Fitted fitted{scene.params, std::max<Eigen::Index>(1, std::lround(scene.between / dt))};
  Parameters& params = fitted.params;
  params.dt = scene.between / static_cast<double>(fitted.n);
  if (lift == Lift::scaled) params.delta = kShare * params.dt;
  params.T = static_cast<int>(fitted.n * static_cast<Eigen::Index>(scene.truth.size()) + 1);
  return fitted;
}

double farthest(const std::vector<Vector3>& a, const std::vector<Vector3>& b, double l) {
  const Vector3 weights(1, 1, l / std::numbers::sqrt2);
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    most = std::max(most, (a[i] - b[i]).cwiseProduct(weights).norm());
  return most;
}

std::optional<Trajectory> motion(const State& start, Parameters params, double dt, double seconds) {
  params.dt = dt;
  params.T = static_cast<int>(std::round(seconds / dt)) + 1;
  Trajectory trajectory = simulated(start, params);
  if (!is_usable(trajectory, params)) return {};
  return trajectory;
}

std::array<double, 2> lowest_heights(const Vector3& q, double l) {
  const double turned = q(2) + std::numbers::pi / 4, reach = l / std::numbers::sqrt2;
  const auto [less, more] = std::minmax({std::abs(std::sin(turned)), std::abs(std::cos(turned))});
  return {q(1) - reach * more, q(1) - reach * less};
}

}  // namespace bounce::study
