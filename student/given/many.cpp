#include "many.hpp"

#include <algorithm>
#include <numbers>

#include "simulated.hpp"

namespace bounce {
namespace {

constexpr int kSquares = 200;
constexpr double kSpread = 0.1 * std::numbers::pi / 180;  // of the angles at the start, rad
constexpr int kMostColumns = 250;                         // of each that are drawn

// Every n-th column, to a hundredth of a millimetre.
Eigen::Matrix3Xd thinned(const Eigen::Matrix3Xd& q, Eigen::Index n) {
  Eigen::Matrix3Xd kept(3, (q.cols() - 1) / n + 1);
  for (Eigen::Index t = 0; t < kept.cols(); ++t)
    kept.col(t) = (q.col(n * t) * 1e5).array().round() / 1e5;
  return kept;
}

}  // namespace

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
