// Measures speed against accuracy: several programs take turns at scenes with smaller and smaller
// steps.
//
// The error is measured in the first round, which starts as the scene does, against the true motion
// (event_driven.hpp), which is computed here. The time is measured in the other rounds, whose
// initial velocities are changed at random by about a thousandth, so that answers which were kept
// or computed beforehand are wrong there. Whoever runs a contender has to check every round's
// columns.
//
// delta is proportional to dt, and the assignment's at dt = 0.01 s. With a fixed delta, the error
// of any correct program stops falling at some multiple of delta, which says nothing about the
// program.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "../../solution/exact/truth.hpp"
#include "termination.hpp"

namespace bounce::judge {

// A trajectory, and the CPU time that it took, ns.
struct Timed {
  Trajectory trajectory = {};
  double ns = 0;
};

// Computes a trajectory. If it fails, throws Termination, or std::runtime_error with a sentence.
using Contender = std::function<Timed(const Parameters& params, const State& start)>;

struct Point {
  double dt;             // s
  double ns_per_second;  // CPU time for a simulated second, the least of the rounds
  double error;          // m, of the first round; infinite where a number is missing
};

// Why a contender was cut off, and at which dt, s.
struct Cut {
  double dt;
  std::string sentence;
  std::optional<Termination> end = {};
};

// The points of one contender, by scene and then by dt; fewer if it was cut off.
struct Curves {
  std::vector<std::vector<Point>> points;
  std::optional<Cut> cut = {};
};

// Time steps, s, from the assignment's downwards.
inline const std::vector<double> kMeasuredSteps{1e-2, 3e-3, 1e-3, 3e-4, 1e-4, 3e-5, 1e-5};

// The curves of each contender. A contender is cut off if it throws, or after `budget_ns` of CPU
// time.
std::vector<Curves> speed_curves(const std::vector<exact::Scene>& scenes,
                                 const std::vector<Contender>& contenders, double budget_ns);

}  // namespace bounce::judge
