// Whole drops of the measured square: flight with drag, and a law at each impact.
#pragma once

#include <string_view>
#include <vector>

#include "laws.hpp"

namespace bounce::measured {

struct World {
  double side, gyration_squared;  // m, m^2
  double ground, slope;           // its height at x = 0, m, and dy/dx
  double g, drag;                 // m/s^2 downwards, 1/s of every velocity
  double interval;                // s between samples
};

// The poses after 1 to `samples` intervals. "assignment" as the law is the assignment's own scheme,
// with a level ground, no drag and r_g^2 = l^2 / 6. Throws std::invalid_argument for an unknown
// law.
std::vector<methods::Motion<double>> drop(const World& world, methods::Motion<double> start,
                                          std::string_view law, const Setting& with, int samples);

}  // namespace bounce::measured
