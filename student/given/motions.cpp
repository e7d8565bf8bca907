#include <bounce/part4_simulate.hpp>
#include <cmath>
#include <map>
#include <numbers>
#include <sstream>
#include <stdexcept>

#include "drawing.hpp"
#include "study/page.hpp"
#include "study/tables.hpp"

namespace bounce {
namespace {

constexpr int kSquares = 200;
constexpr double kSpread = 0.1 * std::numbers::pi / 180;  // of the angles at the start, rad
constexpr int kMostDrawn = 250;                           // columns of each
constexpr int kMostColumns = 1'000'000;

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

// Sets numbers of the scene: "dt=0.001", "vy=-60". It lasts as long as before, unless T is set.
void change(study::Scene& scene, const std::vector<std::string>& assignments) {
  auto& [q, v] = scene.start;
  Parameters& p = scene.params;
  const double seconds = (p.T - 1) * p.dt;
  double columns = NAN;
  const std::map<std::string, double*> numbers = {
      {"l", &p.l},     {"m", &p.m},         {"mu", &p.mu},   {"epsilon", &p.epsilon},
      {"dt", &p.dt},   {"delta", &p.delta}, {"T", &columns}, {"x", &q(0)},
      {"y", &q(1)},    {"theta", &q(2)},    {"vx", &v(0)},   {"vy", &v(1)},
      {"omega", &v(2)}};
  for (const std::string& assignment : assignments) {
    const std::size_t sign = assignment.find('=');
    const auto number = numbers.find(assignment.substr(0, sign));
    std::istringstream text(sign == std::string::npos ? "" : assignment.substr(sign + 1));
    double x = 0;
    if (number == numbers.end() || !(text >> x) || !text.eof()) {
      throw std::invalid_argument(assignment + " sets no number of a scene; dt=0.001 would");
    }
    *number->second = x;
  }
  if (!(p.l > 0 && p.m > 0 && p.dt > 0)) {
    throw std::invalid_argument("l, m and dt have to be greater than 0");
  }
  if (std::isnan(columns)) columns = std::round(seconds / p.dt) + 1;
  if (!(columns >= 1 && columns <= kMostColumns && columns == std::floor(columns))) {
    std::ostringstream message;
    message << "T has to be a whole number from 1 to " << kMostColumns << ", and it is " << columns;
    throw std::invalid_argument(message.str());
  }
  p.T = static_cast<int>(columns);
}

// The named scene, with numbers changed as the other words say.
study::Scene scene_of(const std::vector<std::string>& words) {
  std::string names;
  for (study::Scene& scene : study::read_scenes(BOUNCE_HOME u8"/fixtures/study.json")) {
    names += " " + scene.name;
    if (words.empty() || scene.name != words[0]) continue;
    change(scene, {words.begin() + 1, words.end()});
    return scene;
  }
  throw std::invalid_argument("the scenes are:" + names);
}

}  // namespace

Trajectory simulated(const State& start, const Parameters& params) {
  Trajectory trajectory = simulate(start.q, start.v, params);
  const std::string sentence = missing(trajectory.q, params);
  if (!sentence.empty()) throw std::runtime_error("there is nothing to show yet: " + sentence);
  return trajectory;
}

Drawing drawing_of(const std::vector<std::string>& words) {
  const study::Scene scene = scene_of(words);
  return {simulated(scene.start, scene.params), scene.params, {}, scene.title};
}

Drawing many(const std::vector<std::string>& words) {
  const bool names_scene = !words.empty() && words[0].find('=') == std::string::npos;
  std::vector<std::string> all{"tumble", "epsilon=0.9", "y=1", "dt=0.002", "T=1501"};
  if (names_scene) all.clear();
  all.insert(all.end(), words.begin(), words.end());
  const study::Scene scene = scene_of(all);
  const int n = (scene.params.T - 1) / kMostDrawn + 1;
  Drawing drawing;
  drawing.params = scene.params;
  drawing.params.dt *= n;
  drawing.title = "200 throws, almost alike";
  drawing.about = "T = " + std::to_string(scene.params.T) +
                  ", dt = " + study::number(scene.params.dt) + " s" +
                  (n > 1 ? "; 1 column in " + std::to_string(n) + " is drawn" : "");
  for (int k = 0; k < kSquares; ++k) {
    State start = scene.start;
    start.q(2) += kSpread * (k / (kSquares - 1.0) - 0.5);
    drawing.many.push_back(thinned(simulated(start, scene.params).q, n));
  }
  drawing.trajectory = {drawing.many[kSquares / 2], Eigen::Matrix3Xd(3, 0)};
  return drawing;
}

}  // namespace bounce
