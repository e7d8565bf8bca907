// Rules for wrong numbers: a factor, a difference, a constant, few digits.
#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "findings.hpp"
#include "recognise.hpp"

namespace bounce::tests {
namespace {

using Eigen::Index;
using Numbers = std::vector<Number>;

constexpr double kFewDigits = 1e-4;
constexpr double kAlmostNothing = 1e-9;  // numbers below this count as 0
constexpr double kLeastRatio = 1e-6;

// What the numbers are, if none is finite.
std::optional<Pattern> not_finite(const std::string& subject, const Numbers& numbers) {
  bool any_nan = false, any_infinite = false;
  for (const Number& n : numbers) {
    if (std::isfinite(n.got)) return {};
    (std::isnan(n.got) ? any_nan : any_infinite) = true;
  }
  if (!any_nan) return Pattern{"is_inf", {subject}};
  return Pattern{"is_nan", {subject, any_infinite ? "nan or inf" : "nan"}};
}

// Whether each number is this function of its question and of the right one.
bool are(const Numbers& numbers, const std::function<double(const Number&)>& rule) {
  return std::all_of(numbers.begin(), numbers.end(), [&](const Number& n) {
    return std::abs(n.right) > kAlmostNothing && same(rule(n), n.got);
  });
}

// "0.5", "m" or "mu or 1/2": a parameter only where it varies, as else it may as well be a number.
std::string factor_of(const WrongPart& part, const Numbers& numbers) {
  const double ratio = numbers[0].got / numbers[0].right;
  // A smaller ratio is a rounding error of 0, a larger one that of a right 0.
  const bool is_sure = std::abs(ratio) > kLeastRatio && std::abs(ratio) < 1 / kLeastRatio;
  if (are(numbers, [&](const Number& n) { return ratio * n.right; })) {
    return is_sure ? digits(ratio) : "";
  }
  Words fit;
  for (const auto& [id, words, formula] : alternatives("factors")) {
    const Column factor = value(formula, part.columns);
    if (are(numbers, [&](const Number& n) { return factor(Index(n.question)) * n.right; }))
      fit.push_back(words);
  }
  return joined(fit, " or ");
}

std::optional<Pattern> rule_of(const std::string& subject, const WrongPart& part,
                               const Numbers& numbers) {
  if (numbers.size() < kEnough) return {};
  if (const auto infinite = not_finite(subject, numbers)) return infinite;
  const double got = numbers[0].got, right = numbers[0].right, difference = got - right;
  const bool varies = std::any_of(numbers.begin(), numbers.end(),
                                  [&](const Number& n) { return !same(n.right, right); });
  const bool is_rounding = got != 0 && std::abs(got) < kAlmostNothing;
  if (varies && !is_rounding && are(numbers, [&](const Number&) { return got; }))
    return Pattern{"is_constant", {subject, digits(got)}};
  const std::string factor = factor_of(part, numbers);
  if (!factor.empty()) return Pattern{"is_times", {subject, factor}};
  if (!are(numbers, [&](const Number& n) { return n.right + difference; })) return {};
  return Pattern{difference > 0 ? "is_more" : "is_less", {subject, digits(std::abs(difference))}};
}

bool have_few_digits(const Numbers& numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](const Number& n) {
    return std::abs(n.got - n.right) < kFewDigits * std::max(1e-3, std::abs(n.right));
  });
}

}  // namespace

Patterns rules(const WrongPart& part, const Numbers& numbers) {
  if (have_few_digits(numbers)) return {{"few_digits"}};
  Patterns found;
  std::size_t wrong = 0;
  for (const auto& [name, entries] : quantities(part.part)) {
    Numbers own;
    for (const Number& n : numbers) {
      if (std::count(entries.begin(), entries.end(), n.entry) > 0) own.push_back(n);
    }
    wrong += own.empty() ? 0 : 1;
    const std::string in = entries.size() == 1 ? "" : "number in ";
    const auto rule = rule_of("Every wrong " + in + name, part, own);
    if (rule && found.size() < 2) found.push_back(*rule);
  }
  const auto all = wrong > 1 ? rule_of("Every wrong number", part, numbers) : std::nullopt;
  return all ? Patterns{*all} : found;
}

}  // namespace bounce::tests
