// Given: what the program bounce does with your four parts.
#pragma once

#include <bounce/types.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "study/tables.hpp"

namespace bounce {

// What the page of the animation draws.
struct Drawing {
  Trajectory trajectory;  // without v, no forces, energies and true motion are drawn
  Parameters params;
  std::vector<Eigen::Matrix3Xd> many{};  // more trajectories, drawn thin
  std::string title{};                   // "" for the usual one
};

// As JSON, which the page's script reads. Throws std::invalid_argument where it can't be drawn.
std::string data_of(const Drawing& drawing);

// Writes the page, as render does.
void draw(const Drawing& drawing, const std::filesystem::path& page);

// What `simulate` returns. Throws std::runtime_error with a sentence that says where to look if
// that can't be shown.
Trajectory simulated(const State& start, const Parameters& params);

// The scene 200 times, from angles that are within a tenth of a degree. Throws as `simulated` does.
Drawing many(const study::Scene& scene);

// Takes the step that the handout carries through ("One contact by numbers"), and prints what each
// part returns. Step into it with a debugger.
void worked_example();

}  // namespace bounce
