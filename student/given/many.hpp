// Given: --many, one picture of why long predictions fail.
#pragma once

#include <string>
#include <vector>

#include "drawing.hpp"
#include "study/tables.hpp"

namespace bounce {

// A scene in which small differences grow fast, with the numbers that make it so.
inline const std::vector<std::string> kLively{"tumble", "epsilon=0.9", "y=1", "dt=0.002", "T=1501"};

// The scene 200 times, from angles that are within a tenth of a degree. Throws as `simulated` does.
Drawing many(const study::Scene& scene);

}  // namespace bounce
