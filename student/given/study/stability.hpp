// Given: tries your parts where time steps fail.
#pragma once

#include "page.hpp"
#include "tables.hpp"

namespace bounce::study {

// A place where methods fail, as the page calls it; what your parts do there, in a few words; and
// the lines of its chart. The page has the words that are always the same.
struct Trial {
  std::string name, found;
  std::vector<Line> lines;
};

std::vector<Trial> trials(const Parameters& params);

}  // namespace bounce::study
