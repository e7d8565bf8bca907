#include <algorithm>
#include <climits>
#include <cmath>
#include <numbers>
#include <optional>

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

// The columns that are compared, as far as they are right, and from where on they are 0.
struct Filled {
  int right, zero;
};

std::optional<Filled> filled(const Asked& a) {
  const std::vector<int> columns = known_columns(a.c.params.T);
  const auto is = [&](std::size_t k, auto&& holds) {
    for (Index i = 0; i < kRows; ++i)
      if (!holds(static_cast<Index>(k) * kRows + i)) return false;
    return true;
  };
  std::size_t k = 0;
  while (k < columns.size() && is(k, [&](Index i) { return same(a.got(i), a.right(i)); })) ++k;
  const Filled found{k == 0 ? -1 : columns[k - 1], k < columns.size() ? columns[k] : a.c.params.T};
  while (k < columns.size() && is(k, [&](Index i) { return a.got(i) == 0; })) ++k;
  return k < columns.size() || found.right < 0 ? std::nullopt : std::optional(found);
}

void add_zeros(Words& sentences, const std::vector<Asked>& all) {
  int right = 0, zero = INT_MAX;
  std::size_t unfinished = 0;
  for (const Asked& a : all) {
    const std::optional<Filled> found = filled(a);
    if (!found) return;
    right = std::max(right, found->right);
    if (found->zero == a.c.params.T) continue;
    zero = std::min(zero, found->zero);
    ++unfinished;
  }
  if (unfinished < kEnough) return;
  const std::string compared = ", of those that are compared.";
  sentences.push_back(right < zero
                          ? "The trajectory is right up to column " + std::to_string(right) +
                                ", and 0 from column " + std::to_string(zero) + " on" + compared
                          : "The trajectory is right in its first columns, and 0 in all columns "
                            "after them" +
                                compared);
}

// q or v of columns 1 and 2 that belong into the columns before or after them.
void add_shift(Words& sentences, const std::vector<Asked>& all) {
  for (const Index first : {0, 3}) {
    for (const Index columns : {1, -1}) {
      std::size_t shifted = 0, others = 0;
      for (const Asked& a : all) {
        if (a.c.params.T < 4) continue;
        const auto is = [&](Index by) {
          return same(Answer{a.got.segment(kRows + first, 3), ""},
                      Answer{a.right.segment((1 + by) * kRows + first, 3), ""}) &&
                 same(Answer{a.got.segment(2 * kRows + first, 3), ""},
                      Answer{a.right.segment((2 + by) * kRows + first, 3), ""});
        };
        (is(columns) && !is(0) ? shifted : others) += 1;
      }
      if (shifted < kEnough || others > 0) continue;
      const std::string name = first == 0 ? "q" : "v";
      sentences.push_back("Your " + name + " in columns 1 and 2 is the right one of columns " +
                          (columns > 0 ? "2 and 3" : "0 and 1") + " in every question: is " + name +
                          " one column " + (columns > 0 ? "ahead?" : "late?"));
    }
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
  add_zeros(sentences, all);
  if (sentences.empty()) add_rows(sentences, all);
  add_shift(sentences, all);
  add_start(sentences, all);
  add_few_digits(sentences, all);
  return sentences;
}

}  // namespace bounce::tests
