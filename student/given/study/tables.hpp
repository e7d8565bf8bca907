// Given: what the study compares with, from fixtures/study.json: scenes, where the square really is
// in them, and what other methods reached in how much time.
#pragma once

#include <bounce/types.hpp>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace bounce::study {

using nlohmann::json;

struct Scene {
  std::string name, title;
  Parameters params;
  State start;
  double between = 0;            // s from one place of the truth to the next, the last one the end
  std::vector<Vector3> truth{};  // where the square really is; empty where that isn't studied
  json others{};  // methods, each with its "name" and what it "reached": rows time, error. The time
                  // is for a simulated second, in calls of solve_lcp (lcp_seconds in measure.hpp),
                  // so that it holds on every machine; the error in m
};

// Of the fixtures. Throws std::runtime_error, naming the file.
inline json read_json(const std::filesystem::path& file) {
  std::ifstream in(file);
  json read = json::parse(in, nullptr, false);
  if (read.is_discarded())
    throw std::runtime_error(file.string() + " is missing: unpack the handout again");
  return read;
}

// Of three numbers, of an object with "q" and "v", and of one with all parameters. They throw
// json::exception.
inline Vector3 vector_of(const json& numbers) {
  return {numbers.at(0).get<double>(), numbers.at(1).get<double>(), numbers.at(2).get<double>()};
}

inline State state_of(const json& object) {
  return {vector_of(object.at("q")), vector_of(object.at("v"))};
}

inline Parameters parameters_of(const json& p) {
  return {p.at("l"),  p.at("m"),     p.at("mu"), p.at("epsilon"), vector_of(p.at("g")),
          p.at("dt"), p.at("delta"), p.at("T")};
}

// Throws as read_json does.
inline std::vector<Scene> read_scenes(const std::filesystem::path& file) {
  std::vector<Scene> scenes;
  for (const json& read : read_json(file)) {
    scenes.push_back({read["name"], read["title"], parameters_of(read["params"]), state_of(read)});
    Scene& scene = scenes.back();
    for (const json& row : read["truth"]) {
      scene.truth.emplace_back(row[1].get<double>(), row[2].get<double>(), row[3].get<double>());
    }
    if (!scene.truth.empty()) scene.between = read["truth"][0][0];
    scene.others = read["others"];
  }
  return scenes;
}

}  // namespace bounce::study
