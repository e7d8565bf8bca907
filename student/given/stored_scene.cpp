#include "stored_scene.hpp"

#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace bounce {
namespace {

using nlohmann::json;

Vector3 vector(const json& numbers) {
  return {numbers.at(0).get<double>(), numbers.at(1).get<double>(), numbers.at(2).get<double>()};
}

StoredScene read(const json& from) {
  const json &p = from.at("params"), &input = from.at("input"), &q = from.at("expected").at("q");
  StoredScene scene{vector(input.at("q_0")), vector(input.at("v_0")), {}, {}};
  scene.params = {p.at("l"),         p.at("m"),  p.at("mu"),    p.at("epsilon"),
                  vector(p.at("g")), p.at("dt"), p.at("delta"), p.at("T")};
  scene.right.resize(3, static_cast<Eigen::Index>(q.size()));
  for (std::size_t t = 0; t < q.size(); ++t) {
    scene.right.col(static_cast<Eigen::Index>(t)) = vector(q.at(t));
  }
  return scene;
}

}  // namespace

StoredScene stored_scene(const std::filesystem::path& folder) {
  const auto file = folder / "part4_simulate.json";
  std::ifstream in(file);
  if (!in) throw std::runtime_error(file.string() + " is missing: unpack the handout anew");
  const json checks = json::parse(in).at("checks");
  for (const json& c : checks.at("part4.StepsFromTheColumnBefore")) {
    if (c.at("expected").at("columns").size() == c.at("params").at("T")) return read(c);
  }
  throw std::runtime_error(file.string() + " holds no whole trajectory");
}

}  // namespace bounce
