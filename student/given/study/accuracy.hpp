// Given: what the runs of a scene say of accuracy and speed: two charts, and sentences.
#pragma once

#include "chart.hpp"
#include "measure.hpp"

namespace bounce::study {

// With fixed and with scaled delta.
struct Both {
  std::vector<Run> fixed, scaled;
};

// Error over time, beside other methods, whose times are in calls of solve_lcp; one takes `one_lcp`
// seconds here. And error over step.
std::vector<Chart> charts_of(const Scene& scene, const Both& runs, double one_lcp);

// The best that the program reaches, and whether a smaller step would help.
std::string accuracy(const Scene& scene, const std::vector<Run>& fixed);

// What the method, the last of the scene's, reaches in the time of that best run.
std::string in_the_same_time(const Scene& scene, const std::vector<Run>& fixed, double one_lcp);

}  // namespace bounce::study
