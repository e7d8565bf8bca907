#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

#include "findings.hpp"
#include "recognise.hpp"

namespace bounce::tests {
namespace {

using Eigen::Index;

constexpr std::size_t kMost = 5;  // patterns

std::vector<Number> wrong_numbers(const WrongPart& part) {
  std::vector<Number> wrong;
  for (std::size_t k = 0; k < part.got.size(); ++k) {
    for (Index i = 0; i < part.got[k].numbers.size(); ++i) {
      const double right = part.right[k].numbers(i), got = part.got[k].numbers(i);
      if (!same(right, got)) wrong.push_back({k, i, right, got});
    }
  }
  return wrong;
}

bool has(const Quantity& quantity, const Number& n) {
  return std::count(quantity.entries.begin(), quantity.entries.end(), n.entry) > 0;
}

Pattern which(int part, const std::vector<Number>& wrong, bool all_answered) {
  Words right, touched;
  for (const Quantity& quantity : quantities(part)) {
    const bool is_wrong =
        std::any_of(wrong.begin(), wrong.end(), [&](const Number& n) { return has(quantity, n); });
    (is_wrong ? touched : right).push_back(quantity.name);
  }
  if (right.empty()) return {"wrong", {joined(touched)}};
  const char* id = part == 4      ? "right_and_wrong_columns"
                   : all_answered ? "right_and_wrong"
                                  : "right_and_wrong_of_answered";
  return {id, {joined(touched), joined(right)}};
}

// Whether it holds of a number in these answers.
template <class Holds>
bool any_number(const Answers& got, Holds holds) {
  return std::any_of(got.begin(), got.end(), [&](const Answer& answer) {
    return std::any_of(answer.numbers.begin(), answer.numbers.end(), holds);
  });
}

// What formula or rule the numbers follow: one that needs no case set apart.
Patterns formula_or_rule(const WrongPart& part, const std::vector<Number>& wrong) {
  Patterns found = formulas(part, "corners ");
  if (found.empty()) found = formulas(part);
  return found.empty() && part.part != 4 ? rules(part, wrong) : found;
}

// What is said alone, if anything is.
Patterns alone(const WrongPart& part) {
  double garbage = 0;
  const auto is_it = [&](double x) { return is_garbage(garbage = x); };
  if (any_number(part.got, is_it)) return {{"never_set", {digits(garbage)}}};
  if (answers_differ_when_asked_again(part)) return {{"another_answer"}};
  return formulas(part, "exchanges ");
}

}  // namespace

std::vector<Quantity> quantities(int part) {
  std::vector<Quantity> all;
  for (const auto& [id, name, entries] : alternatives("answer" + std::to_string(part))) {
    all.push_back({name, {}});
    std::istringstream numbers(entries);
    for (Index i = 0; numbers >> i;) all.back().entries.push_back(i);
  }
  return all;
}

bool is_finite(const Answer& answer) { return answer.thrown.empty() && answer.numbers.allFinite(); }

std::string digits(double x) {
  if (std::isnan(x)) return "not a number";
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", x == 0 ? 0 : x);  // without the sign of -0
  return text;
}

Patterns patterns(int part, const Cases& cases, const Answers& right, const Answers& got) {
  if (got.size() != right.size() || got.size() != cases.size()) return {};
  if (rows_of(std::to_string(part)).empty()) return {};  // nothing is known of the part
  const WrongPart wrong{part, cases, right, got, columns_of(part, cases, right, got)};
  const std::vector<Number> numbers = wrong_numbers(wrong);
  // A stub's answers need no description.
  if (numbers.empty() || !any_number(got, [](double x) { return x != 0; })) return {};
  const bool all_answered =
      std::all_of(got.begin(), got.end(), [](const Answer& a) { return a.thrown.empty(); });
  Patterns all{which(part, numbers, all_answered)};
  const auto add = [&](const Patterns& more) { all.insert(all.end(), more.begin(), more.end()); };
  if (const Patterns only = alone(wrong); !only.empty()) {
    all.push_back(only[0]);
    return all;
  }
  add(formula_or_rule(wrong, numbers));
  const Patterns responses = inputs(wrong);
  if (responses.empty() && all_answered) add(where(wrong, numbers));
  add(responses);
  if (all.size() > kMost) all.resize(kMost);
  return all;
}

Diagnosis diagnosis(int part, const Cases& cases, const Answers& got) {
  const KnownMistakes known = known_mistakes(part);
  Diagnosis all{recognise(known, got), {}};
  if (all.mistakes.empty()) all.patterns = patterns(part, cases, known.right, got);
  return all;
}

}  // namespace bounce::tests
