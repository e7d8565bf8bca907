#include "wrong_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "recognise.hpp"

namespace bounce::tests {

using Eigen::Index;

std::vector<Index> range(Index from, Index count, Index step) {
  std::vector<Index> all;
  for (Index i = 0; i < count; ++i) all.push_back(from + i * step);
  return all;
}

std::vector<Quantity> quantities(int part) {
  const Words entries{"first entry", "second entry", "third entry"};
  if (part == 1) {
    return {{"J_t", range(0, 3), entries}, {"J_n", range(3, 3), entries}, {"phi", {6}, {}}};
  }
  if (part == 2) {
    Words block;
    for (const char* column : {"0", "1", "2"}) {
      for (const char* row : {"0", "1", "2"}) {
        block.push_back(std::string("V(") + row + ", " + column + ")");
      }
    }
    return {{"the 3x3 block of V", {0, 1, 2, 4, 5, 6, 8, 9, 10}, block},
            {"the last column of V", range(12, 4), {"V(0, 3)", "V(1, 3)", "V(2, 3)", "V(3, 3)"}},
            {"the last row of V", range(3, 4, 4), {"V(3, 0)", "V(3, 1)", "V(3, 2)", "V(3, 3)"}},
            {"p(0)", {16}, {}},
            {"p(1)", {17}, {}},
            {"p(2)", {18}, {}},
            {"p(3)", {19}, {}}};
  }
  return {{"the move q' - q - dt v'", range(0, 3), {"x", "y", "theta"}},
          {"v'", range(3, 3), {"v_x", "v_y", "omega"}}};
}

bool is_touched(const Quantity& quantity, const std::set<Index>& wrong) {
  return std::any_of(quantity.entries.begin(), quantity.entries.end(),
                     [&](Index i) { return wrong.count(i) > 0; });
}

Wrong wrong_numbers(const std::vector<Answer>& right, const std::vector<Answer>& got) {
  Wrong wrong;
  for (std::size_t k = 0; k < got.size(); ++k) {
    if (got[k].numbers.size() != right[k].numbers.size()) continue;
    for (Index i = 0; i < got[k].numbers.size(); ++i) {
      if (same(right[k].numbers(i), got[k].numbers(i))) continue;
      wrong.numbers.push_back({k, i, right[k].numbers(i), got[k].numbers(i)});
      wrong.questions.insert(k);
      wrong.entries.insert(i);
    }
  }
  return wrong;
}

bool is_finite(const Answer& right, const Answer& got) {
  return right.thrown.empty() && got.thrown.empty() && got.numbers.size() == right.numbers.size() &&
         got.numbers.allFinite();
}

std::string joined(const Words& words, const std::string& last) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    text += (i == 0 ? "" : i + 1 == words.size() ? last : ", ") + words[i];
  }
  return text;
}

std::string digits(double x) {
  if (std::isnan(x)) return "not a number";
  if (x == 0) return "0";  // without the sign of -0
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", x);
  return text;
}

}  // namespace bounce::tests
