// Given: tries your parts where time steps fail.
#pragma once

#include "chart.hpp"
#include "tables.hpp"

namespace bounce::study {

// What a place where methods fail asks of your parts, and what they do there, in a few words each.
struct Trial {
  std::string due, found;
  Chart chart;
};

std::vector<Trial> trials(const Parameters& params);

}  // namespace bounce::study
