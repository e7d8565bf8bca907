// Finds out which corners part 1 takes for the lowest.
#pragma once

#include "wrong_numbers.hpp"

namespace bounce::tests {

// "Corner 4 is never chosen", "Your answer is always that of corner 1", and the like. Empty if some
// answer is that of no corner, or if every answer is that of the lowest.
Words corners(const std::vector<Case>& cases, const std::vector<Answer>& right,
              const std::vector<Answer>& got);

}  // namespace bounce::tests
