#include "pattern.hpp"

#include <algorithm>

#include "findings.hpp"
#include "recognise.hpp"

namespace bounce::tests {
namespace {

using Eigen::Index;

constexpr std::size_t kMost = 5;  // sentences
constexpr std::size_t kMostEntries = 4;

// "J_t (third entry)", or the name alone if all entries are wrong, or many.
std::string with_entries(const Quantity& quantity, const std::set<Index>& wrong) {
  Words names;
  for (std::size_t i = 0; i < quantity.names.size(); ++i) {
    if (wrong.count(quantity.entries[i]) > 0) names.push_back(quantity.names[i]);
  }
  const bool are_all = names.size() == quantity.names.size();
  if (names.empty() || are_all || names.size() > kMostEntries) return quantity.name;
  return quantity.name + " (" + joined(names) + ")";
}

// "in every public question"; with an exception, that is also said.
std::string in_those(bool all_answered) {
  return std::string("in every public question") + (all_answered ? "" : " that it answers");
}

std::string which(int part, const Wrong& wrong, bool all_answered) {
  Words right, touched;
  for (const Quantity& quantity : quantities(part)) {
    const bool is_wrong = is_touched(quantity, wrong.entries);
    (is_wrong ? touched : right)
        .push_back(is_wrong ? with_entries(quantity, wrong.entries) : quantity.name);
  }
  const std::string what = "wrong: " + joined(touched) + ".";
  return right.empty() ? "W" + what.substr(1)
                       : "Right " + in_those(all_answered) + ": " + joined(right) + "; " + what;
}

std::string first_wrong_column(const std::vector<Case>& cases, const Wrong& wrong,
                               bool all_answered) {
  std::set<int> firsts;
  for (const std::size_t k : wrong.questions) {
    const auto first = std::find_if(wrong.numbers.begin(), wrong.numbers.end(),
                                    [&](const Number& n) { return n.question == k; });
    const auto column = static_cast<std::size_t>(first->entry / numbers_together(4));
    firsts.insert(known_columns(cases[k].params.T)[column]);
  }
  if (firsts.empty()) return "";
  if (*firsts.begin() < 2 && firsts.size() == 1 && all_answered) {
    return "Column " + std::to_string(*firsts.begin()) +
           " is the first wrong one in every case that is wrong.";
  }
  return *firsts.begin() == 0 ? "In some cases column 0 is wrong already."
                              : "Column 0 is right " + in_those(all_answered) +
                                    "; the first wrong one comes after it.";
}

// Whether these are a stub's answers, which need no description.
bool nothing_is_filled_in(const std::vector<Answer>& got) {
  return std::all_of(got.begin(), got.end(), [](const Answer& a) {
    return std::all_of(a.numbers.data(), a.numbers.data() + a.numbers.size(),
                       [](double x) { return x == 0; });
  });
}

// A number that is garbage; 0 if there is none.
double garbage(const std::vector<Answer>& got) {
  for (const Answer& answer : got) {
    for (const double x : answer.numbers) {
      if (is_garbage(x)) return x;
    }
  }
  return 0;
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
  if (sentences.empty()) sentences = formulas(part, cases, right, got);
  return sentences.empty() && part != 4 ? rules(part, cases, wrong) : sentences;
}

}  // namespace

std::vector<std::string> patterns(int part, const std::vector<Case>& asked,
                                  const std::vector<Answer>& right,
                                  const std::vector<Answer>& got) {
  if (got.size() != right.size() || got.size() != asked.size()) return {};
  const std::vector<Case> cases = part == 3 ? named_by_answer(asked, right) : asked;
  const Wrong wrong = wrong_numbers(right, got);
  if (wrong.numbers.empty() || nothing_is_filled_in(got)) return {};
  const bool all_answered = std::equal(
      got.begin(), got.end(), right.begin(),
      [](const Answer& a, const Answer& b) { return a.numbers.size() == b.numbers.size(); });
  Words sentences;
  add(sentences, part == 4 ? first_wrong_column(cases, wrong, all_answered)
                           : which(part, wrong, all_answered));
  if (const double x = garbage(got); x != 0) {
    add(sentences, "A number in an answer is " + digits(x) + ": was it ever set?");
    return sentences;
  }
  if (answers_differ_when_asked_again(cases, got)) {
    add(sentences,
        "The same question, asked again after others, gets another answer. Often: a static or "
        "global variable, a number that is never set, or `auto` for an expression of Eigen.");
    return sentences;
  }
  const std::string exchange = part == 4 ? "" : exchanged(part, right, got);
  if (!exchange.empty()) {
    add(sentences, exchange);
    return sentences;
  }
  const Words follows = formula_or_rule(part, cases, right, got, wrong);
  const Words responses = inputs(part, cases, right, got, follows);
  add(sentences, responses);
  if (responses.empty() && all_answered) add(sentences, where(part, cases, wrong.questions));
  add(sentences, follows);
  if (sentences.size() > kMost) sentences.resize(kMost);
  return sentences;
}

}  // namespace bounce::tests
