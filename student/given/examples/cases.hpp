// The cases that a student writes, a line each:
//   part 1: y = 0.1, theta = 45 deg -> phi = -0.0414
// What isn't given has its usual value. Behind # stands what nobody reads.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "table.hpp"

namespace bounce::examples {

// One sentence about a place in the file; lines and columns count from 1.
struct Problem : std::runtime_error {
  Problem(std::size_t column_, const std::string& sentence)
      : std::runtime_error(sentence), column(column_) {}
  std::size_t column;
};

// A number that the student gives to a quantity.
struct Given {
  const Quantity* quantity;
  std::size_t column;
  double value;
  double unit;  // of its last digit
};

struct Case {
  int part = 0;
  std::vector<Given> inputs, outputs;
  Values values;  // of all inputs
};

// The case of a line; part 0 if it holds none. Throws Problem.
Case read_case(const std::string& line, const Table& table);

}  // namespace bounce::examples
