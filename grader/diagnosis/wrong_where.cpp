#include <algorithm>
#include <optional>

#include "findings.hpp"

namespace bounce::tests {
namespace {

using Questions = std::set<std::size_t>;

// What is true of some questions, in words that follow "where".
struct Trait {
  std::string words;
  Questions questions;
};

std::vector<Trait> traits(const WrongPart& part, const std::string& list) {
  std::vector<Trait> all;
  for (const auto& [words, formula] : alternatives(list)) {
    all.push_back({words, {}});
    const Column is = value(formula, part.columns);
    for (Eigen::Index k = 0; k < is.size(); ++k) {
      if (is(k) != 0) all.back().questions.insert(static_cast<std::size_t>(k));
    }
  }
  return all;
}

// The traits that fit the wrong questions best: those that the fewest right ones have.
struct Fit {
  Words words;
  Questions questions;
};

std::optional<Fit> closest(const std::vector<Trait>& all, std::size_t count,
                           const Questions& wrong) {
  std::optional<Fit> best;
  for (const auto& [words, questions] : all) {
    const bool has_wrong =
        std::includes(questions.begin(), questions.end(), wrong.begin(), wrong.end());
    if (!has_wrong || questions.size() == count) continue;
    if (best && questions == best->questions) {
      best->words.push_back(words);
    } else if (!best || questions.size() < best->questions.size()) {
      best = Fit{{words}, questions};
    }
  }
  return best && 4 * wrong.size() >= 3 * best->questions.size() ? best : std::nullopt;
}

std::string only_where(const std::string& words, const Fit& fit, const Questions& wrong) {
  const auto all = std::to_string(fit.questions.size()), some = std::to_string(wrong.size());
  return "Wrong only where " + words + ", in " +
         (all == some ? "all " + all : some + " of " + all) + " such cases.";
}

}  // namespace

std::string where(const WrongPart& part, const Questions& wrong) {
  const std::size_t count = part.cases.size();
  // Few right questions may differ in this by chance.
  if (wrong.empty() || count - wrong.size() < kEnough) return "";
  // Tried first: it is a better explanation than a parameter that isn't the assignment's.
  const auto sideways = closest(traits(part, "sideways"), count, wrong);
  if (sideways) return only_where(sideways->words[0], *sideways, wrong);
  const auto numbers = closest(traits(part, "unusual"), count, wrong);
  std::vector<Trait> others;
  for (const Row& row : rows_of("where " + std::to_string(part.part))) {
    for (const Trait& trait : traits(part, row.at("traits"))) others.push_back(trait);
  }
  const auto best = closest(others, count, wrong);
  if (numbers && (!best || numbers->questions.size() <= best->questions.size())) {
    const std::string are = numbers->words.size() == 1 ? " isn't" : " aren't";
    return only_where(joined(numbers->words, " or ") + are + " the assignment's", *numbers, wrong);
  }
  return best ? only_where(best->words[0], *best, wrong) : "";
}

}  // namespace bounce::tests
