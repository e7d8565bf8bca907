// bounce_study simulate: the motion of a scene within a tolerance, and what it needs: which model,
// and which method at which setting.
#pragma once

#include <filesystem>
#include <ostream>
#include <string>

namespace bounce::study {

// Writes JSON: times (s), q and v (m, rad, m/s, rad/s; one list of 3 for each time), method, bound
// (m), horizon (s), the CPU seconds that it took, and
//   "models"   of the ladder, from the smallest on: "model", "error" and "least", of the first that
//              is within the tolerance
//   "methods"  "method", "step" (s) or "tolerance", "error", "ns" (CPU time, the least of a few
//              runs that take turns) and "within": whether it is within the tolerance, and the next
//              finer setting, too, so that it isn't by the luck of one step
//   "impacts"  how many there are until the horizon
//   "doubts"   sentences about numbers that look like another unit or sign
// For the methods it runs every model, and every method from the coarsest setting on, a step from
// each of the answer's times to the next, until two settings in a row are within the tolerance or a
// run would take more than 250,000 steps. Errors are the largest at the answer's times, m, with the
// answer's own bound added: at most this; null where impacts go on without an end.
//
// Throws std::invalid_argument for a scene or a tolerance (m) that can't be read, Refusal for what
// can't be had.
void simulate(const std::filesystem::path& scene, const std::string& tolerance, std::ostream& out);

}  // namespace bounce::study
