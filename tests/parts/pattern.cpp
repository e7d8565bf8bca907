#include "pattern.hpp"

#include <algorithm>

#include "wrong_corner.hpp"
#include "wrong_formulas.hpp"
#include "wrong_numbers.hpp"
#include "wrong_parameters.hpp"
#include "wrong_pi.hpp"
#include "wrong_rules.hpp"
#include "wrong_where.hpp"

namespace bounce::tests {
namespace {

using Eigen::Index;

constexpr std::size_t kMost = 5;  // sentences

// "J_t (third entry)", or the name alone if all entries are wrong.
std::string with_entries(const Quantity& quantity, const std::set<Index>& wrong) {
  Words names;
  for (std::size_t i = 0; i < quantity.names.size(); ++i) {
    if (wrong.count(quantity.entries[i]) > 0) names.push_back(quantity.names[i]);
  }
  if (names.empty() || names.size() == quantity.names.size()) return quantity.name;
  return quantity.name + " (" + joined(names) + ")";
}

std::string which(int part, const Wrong& wrong) {
  Words right, touched;
  for (const Quantity& quantity : quantities(part)) {
    const bool is_wrong = is_touched(quantity, wrong.entries);
    (is_wrong ? touched : right)
        .push_back(is_wrong ? with_entries(quantity, wrong.entries) : quantity.name);
  }
  const std::string what = "wrong: " + joined(touched) + ".";
  return right.empty() ? "W" + what.substr(1)
                       : "Right in every question: " + joined(right) + "; " + what;
}

std::string first_wrong_column(const std::vector<Case>& cases, const Wrong& wrong) {
  std::set<int> firsts;
  for (const std::size_t k : wrong.questions) {
    const auto first = std::find_if(wrong.numbers.begin(), wrong.numbers.end(),
                                    [&](const Number& n) { return n.question == k; });
    const auto column = static_cast<std::size_t>(first->entry / numbers_together(4));
    firsts.insert(known_columns(cases[k].params.T)[column]);
  }
  if (firsts.empty()) return "";
  if (*firsts.begin() < 2 && firsts.size() == 1) {
    return "Column " + std::to_string(*firsts.begin()) +
           " is the first wrong one in every case that is wrong.";
  }
  return *firsts.begin() == 0
             ? "In some cases column 0 is wrong already."
             : "Column 0 is right in every question; the first wrong one comes after it.";
}

// Whether these are a stub's answers, which need no description.
bool nothing_is_filled_in(const std::vector<Answer>& got) {
  return std::all_of(got.begin(), got.end(), [](const Answer& a) {
    return std::all_of(a.numbers.data(), a.numbers.data() + a.numbers.size(),
                       [](double x) { return x == 0; });
  });
}

void add(Words& sentences, const std::string& sentence) {
  if (!sentence.empty()) sentences.push_back(sentence);
}

void add(Words& sentences, const Words& more) {
  sentences.insert(sentences.end(), more.begin(), more.end());
}

// What formula or rule the numbers follow: one that needs no case set apart.
Words formula_or_rule(int part, const std::vector<Case>& cases, const std::vector<Answer>& right,
                      const std::vector<Answer>& got, const Wrong& wrong) {
  Words sentences = part == 1 ? corners(cases, right, got) : Words();
  if (sentences.empty() && part == 1) sentences = written_pi(right, got);
  if (sentences.empty()) sentences = formulas(part, cases, right, got);
  return sentences.empty() && part != 4 ? rules(part, cases, wrong) : sentences;
}

}  // namespace

std::vector<std::string> patterns(int part, const std::vector<Case>& cases,
                                  const std::vector<Answer>& right,
                                  const std::vector<Answer>& got) {
  if (got.size() != right.size() || got.size() != cases.size()) return {};
  const Wrong wrong = wrong_numbers(right, got);
  if (wrong.numbers.empty() || nothing_is_filled_in(got)) return {};
  Words sentences;
  add(sentences, part == 4 ? first_wrong_column(cases, wrong) : which(part, wrong));
  const std::string exchange = part == 4 ? "" : exchanged(part, right, got);
  if (!exchange.empty()) {
    add(sentences, exchange);
    return sentences;
  }
  const Words responses = inputs(part, cases, right, got);
  add(sentences, responses);
  if (responses.empty()) add(sentences, where(part, cases, wrong.questions));
  add(sentences, formula_or_rule(part, cases, right, got, wrong));
  if (sentences.size() > kMost) sentences.resize(kMost);
  return sentences;
}

}  // namespace bounce::tests
