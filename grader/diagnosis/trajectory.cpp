#include <algorithm>
#include <climits>
#include <cmath>

#include "findings.hpp"
#include "recognise.hpp"

namespace bounce::tests {
namespace {

using Eigen::Index;

constexpr Index kPerColumn = 6;     // x, y, theta, v_x, v_y, omega of each known column
constexpr double kOfAFloat = 1e-7;  // a relative difference

using Holds = bool (*)(double right, double got);

bool is_right(double right, double got) { return same(right, got); }
bool is_zero(double, double got) { return got == 0; }
bool is_close(double right, double got) {
  return std::abs(got - right) <= kOfAFloat * std::max(1.0, std::abs(right));
}

// Whether it holds of every n-th number from the first one on.
bool holds(Holds each, const Answer& right, const Answer& got, Index first, Index n = 1,
           Index end = INT_MAX) {
  for (Index i = first; i < std::min(end, got.numbers.size()); i += n) {
    if (!each(right.numbers(i), got.numbers(i))) return false;
  }
  return true;
}

bool hold_in_all(Holds each, const WrongPart& part, Index first, Index n, Index end = INT_MAX) {
  return std::equal(
      part.right.begin(), part.right.end(), part.got.begin(),
      [&](const Answer& a, const Answer& b) { return holds(each, a, b, first, n, end); });
}

void add_rows(Words& sentences, const WrongPart& part) {
  Words good, wrong, zero;
  Index row = 0;
  for (const char* name : {"x", "y", "theta", "v_x", "v_y", "omega"}) {
    const bool is_good = hold_in_all(is_right, part, row, kPerColumn);
    (is_good ? good : wrong).push_back(name);
    if (!is_good && hold_in_all(is_zero, part, row + kPerColumn, kPerColumn)) zero.push_back(name);
    ++row;
  }
  const std::string compared = " in every column that is compared";
  if (!good.empty()) {
    sentences.push_back("Right" + compared + ": " + joined(good) + "; wrong: " + joined(wrong) +
                        ".");
  }
  if (!zero.empty())
    sentences.push_back("Zero" + compared + ", after column 0: " + joined(zero) + ".");
}

// Where the columns that are compared are right, and 0 after that.
void add_zeros(Words& sentences, const WrongPart& part) {
  int last_right = 0, first_zero = INT_MAX;
  std::size_t unfinished = 0;
  for (std::size_t k = 0; k < part.cases.size(); ++k) {
    const std::vector<int> columns = known_columns(part.cases[k].params.T);
    const Answer &right = part.right[k], &got = part.got[k];
    Index filled = 0;
    while (filled < Index(columns.size()) &&
           holds(is_right, right, got, kPerColumn * filled, 1, kPerColumn * (filled + 1))) {
      ++filled;
    }
    if (filled == 0 || !holds(is_zero, right, got, kPerColumn * filled)) return;
    last_right = std::max(last_right, columns[std::size_t(filled - 1)]);
    if (filled == Index(columns.size())) continue;
    first_zero = std::min(first_zero, columns[std::size_t(filled)]);
    ++unfinished;
  }
  if (unfinished < kEnough) return;
  const std::string where =
      last_right < first_zero
          ? "up to column " + std::to_string(last_right) + ", and 0 from column " +
                std::to_string(first_zero) + " on"
          : std::string("in its first columns, and 0 in all columns after them");
  sentences.push_back("The trajectory is right " + where + ", of those that are compared.");
}

}  // namespace

Words trajectory(const WrongPart& part) {
  Words sentences;
  add_zeros(sentences, part);
  if (sentences.empty()) add_rows(sentences, part);
  const Index two = 2 * kPerColumn;
  if (hold_in_all(is_close, part, 0, 1, two) && !hold_in_all(is_right, part, 0, 1, two)) {
    sentences.push_back(
        "Your first two columns are right to six digits or more: is there a float?");
  }
  return sentences;
}

}  // namespace bounce::tests
