// Finds rules behind wrong numbers: a factor, a difference, a constant, few digits, exchanged
// places.
#pragma once

#include <string>
#include <vector>

#include "wrong_numbers.hpp"

namespace bounce::tests {

// Factors by which a number may be wrong, with their names in the assignment.
std::vector<Value> factors(const Parameters& params);

// One sentence if one rule explains every wrong number; else up to two, each for a quantity with
// its own rule; else none.
Words rules(int part, const std::vector<Case>& cases, const Wrong& wrong);

// A sentence if exchanged places explain every answer; else empty.
std::string exchanged(int part, const std::vector<Answer>& right, const std::vector<Answer>& got);

}  // namespace bounce::tests
