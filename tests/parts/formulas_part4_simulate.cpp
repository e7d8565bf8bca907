#include <algorithm>
#include <cmath>
#include <numbers>

#include "formula.hpp"
#include "recognise.hpp"

namespace bounce::tests {
namespace {

using Eigen::Index;

constexpr Index kRows = 6;          // x, y, theta, v_x, v_y, omega of each known column
constexpr double kOfAFloat = 1e-7;  // a relative difference
const char* const kNames[] = {"x", "y", "theta", "v_x", "v_y", "omega"};

bool holds_in_row(const std::vector<Asked>& all, Index row, Index from,
                  bool (*holds)(double right, double got)) {
  return std::all_of(all.begin(), all.end(), [&](const Asked& a) {
    for (Index i = row + from * kRows; i < a.got.size(); i += kRows) {
      if (!holds(a.right(i), a.got(i))) return false;
    }
    return true;
  });
}

void add_rows(Words& sentences, const std::vector<Asked>& all) {
  Words right, wrong, zero;
  for (Index row = 0; row < kRows; ++row) {
    const bool is_row_right =
        holds_in_row(all, row, 0, [](double due, double got) { return same(due, got); });
    (is_row_right ? right : wrong).push_back(kNames[row]);
    const bool is_zero = holds_in_row(all, row, 1, [](double, double got) { return got == 0; });
    if (!is_row_right && is_zero) zero.push_back(kNames[row]);
  }
  if (!right.empty()) {
    sentences.push_back("Right in every column that is compared: " + joined(right) +
                        "; wrong: " + joined(wrong) + ".");
  }
  if (!zero.empty()) {
    sentences.push_back("Zero in every column that is compared, after column 0: " + joined(zero) +
                        ".");
  }
}

// Columns that may stand in place of column 0.
struct Start {
  const char* words;
  double numbers[kRows];
};

std::vector<Start> starts(const Case& c) {
  const double x = c.q(0), y = c.q(1), theta = c.q(2), degree = std::numbers::pi / 180;
  const double v_x = c.v(0), v_y = c.v(1), omega = c.v(2), dt = c.params.dt;
  const Vector3& g = c.params.g;
  const auto fallen = [&](double t) {
    return Start{"", {x, y, theta, v_x + t * g(0), v_y + t * g(1), omega + t * g(2)}};
  };
  Start half = fallen(dt / 2), whole = fallen(dt);
  half.words = "q_0, and v_0 + dt/2 M^-1 f_e";
  whole.words = "q_0, and v_0 + dt M^-1 f_e";
  return {
      {"q_0 in reverse order, and v_0", {theta, y, x, v_x, v_y, omega}},
      {"q_0 with theta multiplied by pi / 180, and v_0", {x, y, theta * degree, v_x, v_y, omega}},
      {"q_0 with theta multiplied by 180 / pi, and v_0", {x, y, theta / degree, v_x, v_y, omega}},
      half,
      whole,
      {"q_0, and -v_0", {x, y, theta, -v_x, -v_y, -omega}}};
}

bool begins_with(const Asked& a, const Start& start) {
  for (Index i = 0; i < kRows; ++i) {
    if (!same(start.numbers[i], a.got(i))) return false;
  }
  return true;
}

void add_start(Words& sentences, const std::vector<Asked>& all) {
  const std::size_t count = starts(all[0].c).size();
  for (std::size_t k = 0; k < count; ++k) {
    if (std::all_of(all.begin(), all.end(),
                    [&](const Asked& a) { return begins_with(a, starts(a.c)[k]); })) {
      add_formula(sentences, "Your column 0", starts(all[0].c)[k].words);
    }
  }
}

void add_few_digits(Words& sentences, const std::vector<Asked>& all) {
  const auto close = [](double due, double got) {
    return std::abs(got - due) <= kOfAFloat * std::max(1.0, std::abs(due));
  };
  bool any_wrong = false;
  for (const Asked& a : all) {
    const Index size = std::min(2 * kRows, a.got.size());
    for (Index i = 0; i < size; ++i) {
      if (!close(a.right(i), a.got(i))) return;
      any_wrong = any_wrong || !same(a.right(i), a.got(i));
    }
  }
  if (any_wrong) {
    sentences.push_back(
        "Your first two columns are right to six digits or more: is there a float?");
  }
}

}  // namespace

Words formulas_of_part4(const std::vector<Asked>& all) {
  Words sentences;
  if (all.size() < kEnough) return sentences;
  add_rows(sentences, all);
  add_start(sentences, all);
  add_few_digits(sentences, all);
  return sentences;
}

}  // namespace bounce::tests
