// Describes patterns in wrong answers that no known mistake explains.
#pragma once

#include <string>
#include <vector>

#include "answers.hpp"

namespace bounce::tests {

// Up to four sentences: which quantities are right and which wrong; in which cases; and whether one
// factor, one difference, exchanged places or too few digits explain every wrong number. Empty if
// there is nothing to say, or if nothing is wrong. The cases are public ones, in the order of the
// answers.
std::vector<std::string> patterns(int part, const std::vector<Case>& cases,
                                  const std::vector<Answer>& right, const std::vector<Answer>& got);

}  // namespace bounce::tests
