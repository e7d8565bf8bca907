// Given: what the study compares with, from fixtures/study.txt: scenes, where the square really is
// in them, and what other methods reached in how much time.
#pragma once

#include <bounce/types.hpp>
#include <filesystem>
#include <string>
#include <vector>

namespace bounce::study {

struct Sample {
  double t;   // s
  Vector3 q;  // m, m, rad
};

// What a method reached in a scene. The time is for a simulated second, in calls of solve_lcp
// (lcp_seconds in measure.hpp), so that it holds on every machine.
struct Reached {
  double lcp_calls, error;  // error in m
};

struct Method {
  std::string name;
  std::vector<Reached> reached;
};

struct Scene {
  std::string name, title;
  Parameters params;
  State start;
  std::vector<Sample> truth;  // at even times, the last one the end; empty where it isn't studied
  std::vector<Method> others;
};

// Throws std::runtime_error, naming the file.
std::vector<Scene> read_scenes(const std::filesystem::path& file);

// Sets numbers of the scene: "dt=0.001", "vy=-60". It lasts as long as before, unless T is set.
// Throws std::invalid_argument.
void change(Scene& scene, const std::vector<std::string>& assignments);

}  // namespace bounce::study
