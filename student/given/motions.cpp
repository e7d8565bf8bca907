#include <algorithm>
#include <bounce/part4_simulate.hpp>
#include <numbers>
#include <stdexcept>

#include "drawing.hpp"

namespace bounce {
namespace {

constexpr int kSquares = 200;
constexpr double kSpread = 0.1 * std::numbers::pi / 180;  // of the angles at the start, rad
constexpr int kMostColumns = 250;                         // of each that are drawn

// Why q can't be shown; empty if it can.
std::string missing(const Eigen::Matrix3Xd& q, const Parameters& params) {
  if (q.cols() != params.T) {
    return "simulate returned " + std::to_string(q.cols()) + " columns and " +
           std::to_string(params.T) + " are due, so please " +
           (q.cols() == 0 ? "fill in" : "look at the size in") + " src/part4_simulate.cpp";
  }
  for (Eigen::Index t = 0; t < q.cols(); ++t) {
    if (q.col(t).allFinite()) continue;
    return "column " + std::to_string(t) +
           " of q holds NaN or infinity, so please look at what step makes of the column before";
  }
  if (q.cols() > 1 && q.rightCols(q.cols() - 1).isZero(0))
    return "step returned only zeros, so please fill in src/part3_step.cpp";
  return "";
}

// Every n-th column, to a hundredth of a millimetre.
Eigen::Matrix3Xd thinned(const Eigen::Matrix3Xd& q, Eigen::Index n) {
  Eigen::Matrix3Xd kept(3, (q.cols() - 1) / n + 1);
  for (Eigen::Index t = 0; t < kept.cols(); ++t)
    kept.col(t) = (q.col(n * t) * 1e5).array().round() / 1e5;
  return kept;
}

}  // namespace

Trajectory simulated(const State& start, const Parameters& params) {
  Trajectory trajectory = simulate(start.q, start.v, params);
  const std::string sentence = missing(trajectory.q, params);
  if (!sentence.empty()) throw std::runtime_error("there is nothing to show yet: " + sentence);
  return trajectory;
}

Drawing many(const study::Scene& scene) {
  const int n = (scene.params.T - 1) / kMostColumns + 1;
  Drawing drawing;
  drawing.params = scene.params;
  drawing.params.dt *= n;
  drawing.title = "200 throws, almost alike";
  for (int k = 0; k < kSquares; ++k) {
    State start = scene.start;
    start.q(2) += kSpread * (k / (kSquares - 1.0) - 0.5);
    drawing.many.push_back(thinned(simulated(start, scene.params).q, n));
  }
  drawing.trajectory = {drawing.many[kSquares / 2], Eigen::Matrix3Xd(3, 0)};
  return drawing;
}

}  // namespace bounce
