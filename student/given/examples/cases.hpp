// The cases that a student writes, a line each:
//   part 1: y = 0.1, theta = 45 deg -> phi = -0.0414
// What isn't given has its usual value. Behind # stands what nobody reads. Each is judged: whether
// it is right, and which wrong programs it catches.
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

struct Verdict {
  std::string place;  // "line 3", or "line 3, column 9" of what can't be read or decided
  int part = 0;       // 0 if that can't be read
  bool is_right = false;
  std::vector<std::string> caught;  // names of wrong programs
  std::string sentence;             // why it isn't right
};

struct Judged {
  std::vector<Verdict> verdicts;            // a line each, without empty ones
  std::vector<std::string> caught, missed;  // names of wrong programs
};

Judged judge(const std::string& cases, const Table& table);

}  // namespace bounce::examples
