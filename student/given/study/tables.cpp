#include "tables.hpp"

#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>

namespace bounce::study {
namespace {

constexpr int kMostColumns = 1'000'000;

Scene read_scene(std::istringstream& line) {
  Scene scene;
  Parameters& p = scene.params;
  double columns = 0;
  line >> scene.name >> p.l >> p.m >> p.mu >> p.epsilon >> p.g(0) >> p.g(1) >> p.g(2) >> p.delta >>
      columns;
  p.T = static_cast<int>(columns);
  for (double& x : scene.start.q) line >> x;
  for (double& x : scene.start.v) line >> x;
  std::getline(line >> std::ws, scene.title);
  return scene;
}

Sample read_sample(std::istringstream& line) {
  Sample sample{};
  line >> sample.t >> sample.q(0) >> sample.q(1) >> sample.q(2);
  return sample;
}

Method read_method(std::istringstream& line) {
  Method method;
  for (Reached r{}; line >> r.lcp_calls >> r.error;) method.reached.push_back(r);
  line.clear();
  std::getline(line >> std::ws, method.name);
  return method;
}

}  // namespace

std::vector<Scene> read_scenes(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::vector<Scene> scenes;
  for (std::string text; std::getline(in, text);) {
    std::istringstream line(text);
    std::string kind;
    line >> kind;
    if (kind == "scene") scenes.push_back(read_scene(line));
    if (kind == "truth") scenes.back().truth.push_back(read_sample(line));
    if (kind == "other") scenes.back().others.push_back(read_method(line));
  }
  if (scenes.empty())
    throw std::runtime_error(file.string() + " is missing: unpack the handout anew");
  return scenes;
}

void change(Scene& scene, const std::vector<std::string>& assignments) {
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

}  // namespace bounce::study
