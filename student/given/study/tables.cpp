#include "tables.hpp"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace bounce::study {
namespace {

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

void change(Scene& scene, const std::string& assignment) {
  auto& [q, v] = scene.start;
  Parameters& p = scene.params;
  double columns = p.T;
  const std::pair<const char*, double*> numbers[] = {
      {"l", &p.l},     {"m", &p.m},         {"mu", &p.mu},   {"epsilon", &p.epsilon},
      {"dt", &p.dt},   {"delta", &p.delta}, {"T", &columns}, {"x", &q(0)},
      {"y", &q(1)},    {"theta", &q(2)},    {"vx", &v(0)},   {"vy", &v(1)},
      {"omega", &v(2)}};
  const std::size_t sign = assignment.find('=');
  for (const auto& [name, place] : numbers) {
    if (assignment.substr(0, sign) != name || sign == std::string::npos) continue;
    std::istringstream text(assignment.substr(sign + 1));
    if (double x = 0; text >> x && text.eof()) {
      *place = x;
      p.T = std::clamp(static_cast<int>(columns), 1, 1'000'000);
      return;
    }
  }
  throw std::invalid_argument(assignment + " sets no number of a scene; dt=0.001 would");
}

}  // namespace bounce::study
