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

#include <memory>
#include <string>
#include <vector>

#include "../../solution/exact/truth.hpp"

namespace bounce::judge {

// A trajectory, and the CPU time that it took, ns.
struct Timed {
  Trajectory trajectory;
  double ns;
};

// A program that computes trajectories. Throws std::runtime_error, with a sentence, if it fails.
class Contender {
 public:
  Contender() = default;
  Contender(const Contender&) = delete;
  Contender& operator=(const Contender&) = delete;
  virtual ~Contender() = default;
  virtual Timed run(const Parameters& params, const State& start) = 0;
};

struct Point {
  double dt;             // s
  double ns_per_second;  // CPU time for a simulated second, the least of the rounds
  double error;          // m, of the first round; infinite where a number is missing
};

// The points of one contender, by scene and then by dt; fewer if it was cut off.
struct Curves {
  std::vector<std::vector<Point>> points;
  std::string cut;  // why it was cut off, or empty
};

// The scenes that the assignment's model can simulate: those that need at most one corner with
// friction. It has no two corners at once, as in a square that rests on a face.
std::vector<exact::Scene> scenes_of_one_corner(std::vector<exact::Scene> all);

// Time steps, s, from the assignment's downwards.
const std::vector<double>& measured_steps();

// The curves of each contender. A contender is cut off if it throws, or if its next points would
// exceed `budget_ns` of CPU time in total.
std::vector<Curves> speed_curves(const std::vector<exact::Scene>& scenes,
                                 const std::vector<std::unique_ptr<Contender>>& contenders,
                                 double budget_ns);

}  // namespace bounce::judge
