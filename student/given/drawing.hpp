// Given: what the page of the animation draws, and with what its page is filled.
#pragma once

#include <bounce/types.hpp>
#include <filesystem>
#include <string>
#include <vector>

namespace bounce {

struct Drawing {
  Trajectory trajectory;  // without v, no forces and energies are drawn
  Parameters params;
  Eigen::Matrix3Xd right{3, 0};          // to compare with; no column if there is none
  std::vector<Eigen::Matrix3Xd> many{};  // more trajectories, drawn thin
  std::string title{};                   // "" for the usual one
};

// As JSON, which the page's script reads. Throws std::invalid_argument where it can't be drawn.
std::string data_of(const Drawing& drawing);

// Writes the page, as render does.
void draw(const Drawing& drawing, const std::filesystem::path& page);

}  // namespace bounce
