// What the numbers themselves say of wrong answers that no known mistake explains.
#pragma once

#include <string>
#include <vector>

#include "answers.hpp"

namespace bounce::tests {

// Up to four sentences, the first of which say what is right: which quantities are wrong; in which
// cases; where it is so, that one factor, one difference, an exchange of places or too few digits
// explain every wrong number. Empty where nothing can be said, or nothing is wrong. The cases are
// public ones, in the order of the answers.
std::vector<std::string> patterns(int part, const std::vector<Case>& cases,
                                  const std::vector<Answer>& right, const std::vector<Answer>& got);

}  // namespace bounce::tests
