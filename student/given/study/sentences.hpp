// Given: what the numbers of the study say, a sentence for each chart.
#pragma once

#include "measure.hpp"

namespace bounce::study {

// With fixed and with scaled delta.
struct Both {
  std::vector<Run> fixed, scaled;
};

// The run from which on a smaller step gains less than half of its error; the last one if every
// step gains.
std::size_t where_it_stalls(const std::vector<Run>& runs);

// The slope of log error over log dt, over the steps below 0.002 s.
double order(const std::vector<Run>& runs);

std::string of_steps(const Scene& scene, const Both& runs);
std::string of_time(const Scene& scene, const Both& runs);
std::string of_depth(const std::vector<Run>& runs, double l);
std::string of_energy(const Energy& coarse, const Energy& fine);
std::string of_rest(const Rest& fixed, const Rest& scaled, const Rest& fine_scaled);

}  // namespace bounce::study
