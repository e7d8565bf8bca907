#include "pattern.hpp"

#include <algorithm>

#include "wrong_numbers.hpp"
#include "wrong_rules.hpp"
#include "wrong_where.hpp"

namespace bounce::tests {
namespace {

using Eigen::Index;

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
                       : "Right in every public case: " + joined(right) + "; " + what;
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
             : "Column 0 is right in every public case; the first wrong one comes after it.";
}

// Whether these are a stub's answers, which need no description.
bool nothing_is_filled_in(const std::vector<Answer>& got) {
  return std::all_of(got.begin(), got.end(), [](const Answer& a) { return a.numbers.isZero(0); });
}

void add(Words& sentences, const std::string& sentence) {
  if (!sentence.empty()) sentences.push_back(sentence);
}

}  // namespace

std::vector<std::string> patterns(int part, const std::vector<Case>& cases,
                                  const std::vector<Answer>& right,
                                  const std::vector<Answer>& got) {
  if (got.size() != right.size() || got.size() != cases.size()) return {};
  const Wrong wrong = wrong_numbers(right, got);
  if (wrong.numbers.empty() || nothing_is_filled_in(got)) return {};
  Words sentences;
  if (part == 4) {
    add(sentences, first_wrong_column(cases, wrong));
    add(sentences, where(part, cases, wrong.questions));
    return sentences;
  }
  add(sentences, which(part, wrong));
  add(sentences, where(part, cases, wrong.questions));
  const std::string exchange = exchanged(part, right, got);
  for (const std::string& rule : exchange.empty() ? rules(part, cases, wrong) : Words{exchange}) {
    add(sentences, rule);
  }
  return sentences;
}

}  // namespace bounce::tests
