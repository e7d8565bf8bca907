#include "formula.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "recognise.hpp"

namespace bounce::tests::formula {
namespace {

constexpr Index kRows = 6;          // x, y, theta, v_x, v_y, omega of each known column
constexpr double kOfAFloat = 1e-7;  // a relative difference
const char* const kNames[] = {"x", "y", "theta", "v_x", "v_y", "omega"};

bool holds_in_row(const std::vector<Asked>& all, Index row, Index from,
                  const std::function<bool(double right, double got)>& holds) {
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

struct Start {
  std::string words;
  std::function<Numbers(const Case&)> value;
};

Numbers both(const Vector3& q, const Vector3& v) {
  Numbers numbers(kRows);
  numbers << q, v;
  return numbers;
}

std::vector<Start> starts() {
  using C = const Case&;
  const double degree = std::numbers::pi / 180;
  const auto with_theta = [](C c, double times) {
    return both({c.q(0), c.q(1), c.q(2) * times}, c.v);
  };
  return {
      {"q_0 in reverse order, and v_0", [](C c) { return both(c.q.reverse(), c.v); }},
      {"q_0 with theta multiplied by pi / 180, and v_0",
       [=](C c) { return with_theta(c, degree); }},
      {"q_0 with theta multiplied by 180 / pi, and v_0",
       [=](C c) { return with_theta(c, 1 / degree); }},
      {"q_0, and v_0 + dt/2 M^-1 f_e",
       [](C c) { return both(c.q, c.v + c.params.dt / 2 * c.params.g); }},
      {"q_0, and v_0 + dt M^-1 f_e", [](C c) { return both(c.q, c.v + c.params.dt * c.params.g); }},
      {"q_0, and -v_0", [](C c) { return both(c.q, -c.v); }}};
}

bool is_start(const Asked& a, const Numbers& start) {
  return std::equal(start.begin(), start.end(), a.got.begin(),
                    [](double due, double got) { return same(due, got); });
}

void add_start(Words& sentences, const std::vector<Asked>& all) {
  for (const Start& start : starts()) {
    if (std::all_of(all.begin(), all.end(),
                    [&](const Asked& a) { return is_start(a, start.value(a.c)); })) {
      sentences.push_back("Your column 0 is " + start.words + " in every question.");
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

Words of_part4(const std::vector<Asked>& all) {
  Words sentences;
  if (all.size() < kEnough) return sentences;
  add_rows(sentences, all);
  add_start(sentences, all);
  add_few_digits(sentences, all);
  return sentences;
}

}  // namespace bounce::tests::formula
