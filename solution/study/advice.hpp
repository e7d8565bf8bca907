// What a scene needs: which model, and which method at which setting, for a tolerance.
#pragma once

#include <string>
#include <vector>

#include "../exact/simulate_to.hpp"

namespace bounce::study {

using namespace exact;

// Errors are the largest at the answer's times, m, with the answer's own bound added: at most this.
// Infinite where impacts go on without an end.
struct ModelRun {
  ModelLevel level;
  double error;
  bool least;  // the first of the ladder that is within the tolerance
};

struct MethodRun {
  std::string method;
  bool has_step;
  double setting;  // a step, s, or a tolerance
  double error;
  double ns;    // CPU time, the least of a few runs that take turns
  bool within;  // the tolerance, as the next finer setting is: not by the luck of one step
};

struct Advice {
  std::vector<ModelRun> models;
  std::vector<MethodRun> methods;
};

// Runs every model, and every method from the coarsest setting on, a step from each of the answer's
// times to the next, until two settings in a row are within the tolerance or a run would take more
// than kMostSteps.
inline constexpr long kMostSteps = 250'000;
Advice advise(const Scene& scene, const Answer& answer, double tolerance);

}  // namespace bounce::study
