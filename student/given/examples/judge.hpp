// Judges the cases that a student writes, a line each:
//   part 1: y = 0.1, theta = 45 deg -> phi = -0.0414
// What isn't given has its usual value. Behind # stands what nobody reads. Said of each case is
// whether it is right, and which buggy programs it catches.
#pragma once

#include <string>
#include <vector>

#include "table.hpp"

namespace bounce::examples {

struct Verdict {
  std::string place;  // "line 3", or "line 3, column 9" of what can't be read or decided
  int part = 0;       // 0 if that can't be read
  bool is_right = false;
  std::vector<std::string> caught;  // names of buggy programs
  std::string sentence;             // why it isn't right
};

struct Judged {
  std::vector<Verdict> verdicts;            // a line each, without empty ones
  std::vector<std::string> caught, missed;  // names of buggy programs
};

Judged judge(const std::string& cases, const Table& table);

}  // namespace bounce::examples
