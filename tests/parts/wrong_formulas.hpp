// Finds formulas that a part's wrong answers follow.
#pragma once

#include "wrong_numbers.hpp"

namespace bounce::tests {

// "Your phi is y - l/2 in every question", and the like: a formula that gives all of a quantity's
// numbers where the right one doesn't. If two formulas do, both are named; if more do, none is.
Words formulas(int part, const std::vector<Case>& cases, const std::vector<Answer>& right,
               const std::vector<Answer>& got);

}  // namespace bounce::tests
