#include "findings.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "recognise.hpp"

namespace bounce::tests {
namespace {

using Eigen::Index;

constexpr double kFewDigits = 1e-4;
constexpr double kAlmostNothing = 1e-9;  // numbers below this count as 0
constexpr double kLeastRatio = 1e-6;

// --- words ---

// What the numbers are, if none is finite; else empty.
std::string not_finite(const std::vector<Number>& numbers) {
  const auto count = [&](bool (*is)(double)) {
    return std::count_if(numbers.begin(), numbers.end(),
                         [&](const Number& n) { return is(n.got); });
  };
  const auto all = static_cast<std::ptrdiff_t>(numbers.size());
  const auto nan = count([](double x) { return std::isnan(x); });
  const auto infinite = count([](double x) { return std::isinf(x); });
  if (numbers.size() < kEnough || nan + infinite < all) return "";
  if (nan == 0)
    return "inf. Often: something is divided by 0; as whole numbers, 1/2 and 1/6 are 0.";
  return std::string(infinite == 0 ? "nan" : "nan or inf") +
         ": was it ever set? If so, look for a division by 0, or sqrt(-1).";
}

// --- rules ---

// Whether each wrong number is FACTOR times the right one, plus something.
bool is_rule(const std::vector<Number>& numbers, double factor, double plus) {
  return numbers.size() >= kEnough &&
         std::all_of(numbers.begin(), numbers.end(), [&](const Number& n) {
           return std::abs(n.right) > kAlmostNothing && same(factor * n.right + plus, n.got);
         });
}

// Whether it is the i-th of the known factors.
bool is_factor(std::size_t i, const std::vector<Case>& cases, const std::vector<Number>& numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [&](const Number& n) {
    const double factor = factors(cases[n.question].params)[i].value;
    return std::abs(n.right) > kAlmostNothing && same(factor * n.right, n.got);
  });
}

std::string factor_of(const std::vector<Case>& cases, const std::vector<Number>& numbers) {
  if (numbers.size() < kEnough) return "";
  const double ratio = numbers[0].got / numbers[0].right;
  // A smaller ratio is a rounding error of 0, a larger one that of a right 0.
  const bool is_sure = std::abs(ratio) > kLeastRatio && std::abs(ratio) < 1 / kLeastRatio;
  if (is_rule(numbers, ratio, 0)) return is_sure ? digits(ratio) : "";
  const std::vector<Value> known = factors({});
  Words fit;  // a parameter only where it varies: else it may as well be a number
  for (std::size_t i = 0; i < known.size(); ++i) {
    if (is_factor(i, cases, numbers)) fit.push_back(known[i].words);
  }
  return joined(fit, " or ");
}

std::string difference_of(const std::vector<Number>& numbers) {
  if (numbers.empty()) return "";
  const double difference = numbers[0].got - numbers[0].right;
  const bool constant = is_rule(numbers, 1, difference);
  return constant ? digits(std::abs(difference)) + (difference > 0 ? " more" : " less") : "";
}

std::string constant_of(const std::vector<Number>& numbers) {
  if (numbers.empty()) return "";
  const bool is_one = is_rule(numbers, 0, numbers[0].got);
  const bool varies = std::any_of(numbers.begin(), numbers.end(), [&](const Number& n) {
    return !same(n.right, numbers[0].right);
  });
  const bool is_rounding = numbers[0].got != 0 && std::abs(numbers[0].got) < kAlmostNothing;
  return is_one && varies && !is_rounding ? digits(numbers[0].got) : "";
}

std::string rule_of(const std::string& subject, const std::vector<Case>& cases,
                    const std::vector<Number>& numbers) {
  const std::string infinite = not_finite(numbers);
  if (!infinite.empty()) return subject + " is " + infinite;
  const std::string constant = constant_of(numbers), factor = factor_of(cases, numbers);
  if (!constant.empty()) return subject + " is " + constant + ", whatever the right one.";
  if (!factor.empty()) return subject + " is " + factor + " times the right one.";
  const std::string difference = difference_of(numbers);
  return difference.empty() ? "" : subject + " is " + difference + " than the right one.";
}

bool few_digits(const std::vector<Number>& numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](const Number& n) {
    return std::abs(n.got - n.right) < kFewDigits * std::max(1e-3, std::abs(n.right));
  });
}

// --- exchanged places ---

struct Exchange {
  int part;
  std::string words;
  std::vector<Index> from;  // the place that each entry comes from
};

// V and p, or only some of them, for unknowns in another order than eq. (8)'s.
void add_orders_of_unknowns(std::vector<Exchange>& all) {
  const char* const names[] = {"f_n", "f_t1", "f_t2", "lambda"};
  const auto from = [](const std::array<Index, 4>& order, bool block, bool border, bool p) {
    std::vector<Index> places = range(0, 20);
    for (std::size_t k = 0; k < 20; ++k) {
      const std::size_t i = k % 4, j = k / 4;
      const bool is_in_block = i < 3 && j < 3;
      if (j == 4 && p) places[k] = 16 + order[i];
      if (j < 4 && (is_in_block ? block : border)) places[k] = order[i] + 4 * order[j];
    }
    return places;
  };
  std::array<Index, 4> order{0, 1, 2, 3};
  while (std::next_permutation(order.begin(), order.end())) {
    Words unknowns;
    for (const Index i : order) unknowns.push_back(names[i]);
    const std::string words = " in the order z = (" + joined(unknowns, ", ") + ")";
    all.push_back({2, "V and p are" + words, from(order, true, true, true)});
    all.push_back({2, "V is" + words + ", and p isn't", from(order, true, true, false)});
    all.push_back({2, "p is" + words + ", and V isn't", from(order, false, false, true)});
    if (order[3] != 3) continue;
    all.push_back({2, "p and the 3x3 block of V are" + words + ", and the border of V isn't",
                   from(order, true, false, true)});
    all.push_back({2, "the 3x3 block of V is" + words + ", and its border and p aren't",
                   from(order, true, false, false)});
  }
}

std::vector<Exchange> exchanges() {
  const auto matrix = [](Index rows, auto&& from) {
    std::vector<Index> all = range(0, 20);
    for (Index j = 0; j < rows; ++j) {
      for (Index i = 0; i < rows; ++i) all[static_cast<std::size_t>(i + 4 * j)] = from(i, j);
    }
    return all;
  };
  std::vector<Index> p_swapped = range(0, 20);
  std::swap(p_swapped[17], p_swapped[18]);
  std::vector<Exchange> all{
      {1, "the two columns of J are exchanged", {3, 4, 5, 0, 1, 2, 6}},
      {1, "J is filled row by row with what belongs into its columns", {0, 2, 4, 1, 3, 5, 6}},
      {1, "J is filled column by column with what belongs into its rows", {0, 3, 1, 4, 2, 5, 6}},
      {2, "V is transposed", matrix(4, [](Index i, Index j) { return j + 4 * i; })},
      {2, "p(1) and p(2) are exchanged", p_swapped}};
  add_orders_of_unknowns(all);
  return all;
}

bool explains(const Exchange& exchange, const std::vector<Answer>& right,
              const std::vector<Answer>& got) {
  for (std::size_t k = 0; k < got.size(); ++k) {
    for (Index i = 0; i < got[k].numbers.size(); ++i) {
      const Index from = exchange.from[static_cast<std::size_t>(i)];
      if (!same(right[k].numbers(from), got[k].numbers(i))) return false;
    }
  }
  return true;
}

}  // namespace

std::vector<Value> factors(const Parameters& p) {
  return {{"-1", -1},
          {"2", 2},
          {"1/2", 0.5},
          {"dt", p.dt},
          {"1/dt", 1 / p.dt},
          {"m", p.m},
          {"1/m", 1 / p.m},
          {"m^2", p.m * p.m},
          {"mu", p.mu},
          {"epsilon", p.epsilon},
          {"1 + epsilon", 1 + p.epsilon},
          {"1/(1 + epsilon)", 1 / (1 + p.epsilon)}};
}

// One rule for all wrong numbers, or one for each quantity that has its own.
Words rules(int part, const std::vector<Case>& cases, const Wrong& wrong) {
  if (few_digits(wrong.numbers)) {
    return {
        "The wrong numbers are right to four digits or more: is there a float, or a constant with "
        "too few digits?"};
  }
  const std::string all = rule_of("Every wrong number", cases, wrong.numbers);
  if (!all.empty()) return {all};
  Words found;
  for (const Quantity& quantity : quantities(part)) {
    std::vector<Number> own;
    std::copy_if(wrong.numbers.begin(), wrong.numbers.end(), std::back_inserter(own),
                 [&](const Number& n) { return is_touched(quantity, {n.entry}); });
    const std::string subject = quantity.entries.size() == 1
                                    ? "Every wrong " + quantity.name
                                    : "Every wrong number in " + quantity.name;
    const std::string own_rule = rule_of(subject, cases, own);
    if (!own_rule.empty() && found.size() < 2) found.push_back(own_rule);
  }
  return found;
}

std::string exchanged(int part, const std::vector<Answer>& right, const std::vector<Answer>& got) {
  for (const Exchange& exchange : exchanges()) {
    if (exchange.part == part && explains(exchange, right, got)) {
      return "One thing explains every wrong number: " + exchange.words + ".";
    }
  }
  return "";
}

}  // namespace bounce::tests
