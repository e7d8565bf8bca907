// What a scene needs: which model, and which method at which setting, for a tolerance.
#pragma once

#include <nlohmann/json.hpp>

#include "../exact/simulate_to.hpp"

namespace bounce::study {

using namespace exact;

// Runs every model, and every method from the coarsest setting on, a step from each of the answer's
// times to the next, until two settings in a row are within the tolerance or a run would take more
// than kMostSteps. Returns
//   "models"   of the ladder, from the smallest on: "model", "error" and "least", of the first that
//              is within the tolerance
//   "methods"  "method", "step" (s) or "tolerance", "error", "ns" (CPU time, the least of a few
//              runs that take turns) and "within": whether it is within the tolerance, and the next
//              finer setting, too, so that it isn't by the luck of one step
// Errors are the largest at the answer's times, m, with the answer's own bound added: at most this;
// null where impacts go on without an end.
inline constexpr long kMostSteps = 250'000;
nlohmann::ordered_json advise(const Scene& scene, const Answer& answer, double tolerance);

}  // namespace bounce::study
