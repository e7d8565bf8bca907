// By what rule numbers are wrong: a factor, a difference, a constant, few digits, exchanged places.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "wrong_numbers.hpp"

namespace bounce::tests {

// Factors by which a number may be wrong, by the names of the assignment.
std::vector<std::pair<std::string, double>> factors(const Parameters& params);

// One sentence where one rule explains every wrong number; or up to two, each for a quantity that
// has a rule of its own; or none.
Words rules(int part, const std::vector<Case>& cases, const Wrong& wrong);

// A sentence where an exchange of places explains every answer; or an empty one.
std::string exchanged(int part, const std::vector<Answer>& right, const std::vector<Answer>& got);

}  // namespace bounce::tests
