#include "recognise.hpp"

#include <algorithm>
#include <cmath>
#include <istream>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <stdexcept>

namespace bounce::tests {
namespace {

using Eigen::Index;
using json = nlohmann::ordered_json;  // as in cases.cpp, so that it is compiled once

constexpr double kTolerance = 1e-9;

// A number agrees by chance once in a billion. But many mistakes, such as a constant or a branch,
// can cause the same wrong number, or the same wrong answer to one question. So a mistake must show
// in at least four numbers, and in two questions or columns of a trajectory.
constexpr int kNumbers = 4, kQuestions = 2;

// --- reading ---

double number(const json& x) { return x.is_null() ? std::nan("") : x.get<double>(); }

Answer read_answer(const json& words) {
  if (words.is_string()) return {{}, words.get<std::string>()};
  Answer answer{Eigen::VectorXd(static_cast<Index>(words.size())), ""};
  for (Index i = 0; i < answer.numbers.size(); ++i) {
    answer.numbers(i) = number(words.at(static_cast<std::size_t>(i)));
  }
  return answer;
}

// Reads the wrong answers, {question: {entry: number}} or {question: text of an exception}, and
// fills in the right ones.
std::vector<Answer> read_differences(const json& differences, std::vector<Answer> answers) {
  for (const auto& [question, words] : differences.items()) {
    Answer& answer = answers.at(std::stoul(question));
    if (words.is_string()) {
      answer = read_answer(words);
      continue;
    }
    for (const auto& [entry, x] : words.items()) {
      const auto i = static_cast<Index>(std::stoul(entry));
      if (i >= answer.numbers.size()) throw std::runtime_error("an entry that no answer has");
      answer.numbers(i) = number(x);
    }
  }
  return answers;
}

// --- comparing ---

// How often, and where, a mistake shows.
struct Evidence {
  int numbers = 0;
  std::set<std::pair<std::size_t, Index>> questions;
  void add(std::size_t question, Index column) {
    ++numbers;
    questions.insert({question, column});
  }
  bool enough() const {
    return numbers >= kNumbers && static_cast<int>(questions.size()) >= kQuestions;
  }
};

// Where a mistake shows by itself: its number is wrong, and the other answer's is right. Numbers
// that aren't finite don't count, since they have many causes.
Evidence evidence(const std::vector<Answer>& mistaken, const std::vector<Answer>& other,
                  const KnownMistakes& known) {
  Evidence found;
  for (std::size_t k = 0; k < mistaken.size(); ++k) {
    const Answer &a = mistaken[k], &b = other[k], &right = known.right[k];
    if (b.thrown != right.thrown) continue;
    if (a.thrown != right.thrown) found.add(k, 0);
    for (Index i = 0; i < std::min(a.numbers.size(), right.numbers.size()); ++i) {
      const bool shows = std::isfinite(a.numbers(i)) && !same(a.numbers(i), right.numbers(i));
      if (shows && same(b.numbers(i), right.numbers(i))) found.add(k, i / known.together);
    }
  }
  return found;
}

// --- composing ---

// The value of an entry that two mistakes a and b both change.
using Rule = double (*)(double right, double a, double b);
constexpr Rule kRules[] = {
    [](double right, double a, double b) { return right + (a - right) + (b - right); },
    [](double right, double a, double b) { return right == 0 ? NAN : a * (b / right); },
};

// The value of an entry with both mistakes.
double composed(double right, double a, double b, Rule rule) {
  if (same(a, right)) return b;
  return same(b, right) ? a : rule(right, a, b);
}

// The answer with both mistakes. If one of them throws, there are no numbers, so the other doesn't
// show.
std::optional<Answer> composed(const Answer& right, const Answer& a, const Answer& b, Rule rule) {
  if (!a.thrown.empty() && !b.thrown.empty() && a.thrown != b.thrown) return std::nullopt;
  if (!a.thrown.empty() || !b.thrown.empty()) return a.thrown.empty() ? b : a;
  Answer both = right;
  for (Index i = 0; i < right.numbers.size(); ++i) {
    both.numbers(i) = composed(right.numbers(i), a.numbers(i), b.numbers(i), rule);
  }
  return both;
}

// Whether each of the two shows by itself. One that shows only where the other does may as well be
// the half of a third mistake.
bool both_show(const KnownMistakes& known, const Mistake& a, const Mistake& b) {
  return evidence(a.answers, b.answers, known).enough() &&
         evidence(b.answers, a.answers, known).enough();
}

// Whether both together explain the answers, and both are needed.
bool explain(const KnownMistakes& known, const Mistake& a, const Mistake& b, Rule rule,
             const std::vector<Answer>& got) {
  for (std::size_t k = 0; k < got.size(); ++k) {
    const auto both = composed(known.right[k], a.answers[k], b.answers[k], rule);
    if (!both || !same(*both, got[k])) return false;
  }
  return both_show(known, a, b);
}

using Names = std::set<std::size_t>;  // of mistakes, by index

bool explain(const std::vector<Answer>& mistaken, const std::vector<Answer>& got) {
  return std::equal(got.begin(), got.end(), mistaken.begin(),
                    [](const Answer& a, const Answer& b) { return same(a, b); });
}

std::vector<Names> singles(const KnownMistakes& known, const std::vector<Answer>& got) {
  std::vector<Names> found;
  for (std::size_t i = 0; i < known.mistakes.size(); ++i) {
    const auto& mistaken = known.mistakes[i].answers;
    if (explain(mistaken, got)) found.push_back({i});
  }
  return found;
}

std::vector<Names> pairs(const KnownMistakes& known, const std::vector<Answer>& got) {
  std::vector<Names> found;
  for (std::size_t i = 0; i < known.mistakes.size(); ++i) {
    for (std::size_t j = i + 1; j < known.mistakes.size(); ++j) {
      const bool any = std::any_of(std::begin(kRules), std::end(kRules), [&](Rule rule) {
        return explain(known, known.mistakes[i], known.mistakes[j], rule, got);
      });
      if (any) found.push_back({i, j});
    }
  }
  return found;
}

Names in_common(const std::vector<Names>& explanations) {
  Names common = explanations.empty() ? Names() : explanations.front();
  for (const Names& names : explanations) {
    std::erase_if(common, [&](std::size_t i) { return names.count(i) == 0; });
  }
  return common;
}

// Part 3's answers without the move: v' alone.
bool holds_a_state(const std::vector<Answer>& answers) {
  return std::all_of(answers.begin(), answers.end(),
                     [](const Answer& a) { return a.thrown.empty() && a.numbers.size() == 6; });
}

std::vector<Answer> halves(const std::vector<Answer>& answers, bool second) {
  std::vector<Answer> all = answers;
  for (Answer& a : all) a.numbers = (second ? a.numbers.tail(3) : a.numbers.head(3)).eval();
  return all;
}

// The mistakes in v' alone that explain every v'. q' is wrong in another way.
std::vector<Names> singles_of_velocity(const KnownMistakes& known, const std::vector<Answer>& got) {
  if (!holds_a_state(got) || !holds_a_state(known.right)) return {};
  const std::vector<Answer> right = halves(known.right, true), velocities = halves(got, true);
  if (!evidence(velocities, right, {known.together, right, {}}).enough()) return {};
  std::vector<Names> found;
  for (std::size_t i = 0; i < known.mistakes.size(); ++i) {
    const auto& mistaken = known.mistakes[i].answers;
    if (holds_a_state(mistaken) && explain(halves(mistaken, true), velocities) &&
        explain(halves(mistaken, false), halves(known.right, false))) {
      found.push_back({i});
    }
  }
  return found;
}

}  // namespace

KnownMistakes read_mistakes(std::istream& file, int part) {
  const json all = json::parse(file);
  KnownMistakes known{numbers_together(part), {}, {}};
  for (const json& answer : all.at("right")) known.right.push_back(read_answer(answer));
  for (const json& m : all.at("mistakes")) {
    known.mistakes.push_back({m.at("name"), m.at("title"), m.at("sentence"), m.at("hint"),
                              m.at("equations").get<std::vector<int>>(),
                              read_differences(m.at("answers"), known.right)});
  }
  return known;
}

std::vector<Mistake> recognise(const KnownMistakes& known, const std::vector<Answer>& got) {
  if (got.size() != known.right.size() || !evidence(got, known.right, known).enough()) return {};
  for (const Answer& answer : got) {
    if (std::any_of(answer.numbers.begin(), answer.numbers.end(), is_garbage)) return {};
  }
  std::vector<Names> explanations = singles(known, got);
  if (explanations.empty()) explanations = pairs(known, got);
  if (explanations.empty()) explanations = singles_of_velocity(known, got);
  std::vector<Mistake> named;
  for (const std::size_t i : in_common(explanations)) named.push_back(known.mistakes[i]);
  return named;
}

bool is_garbage(double x) {
  constexpr double kLargest = 1e290;
  return std::isfinite(x) && (std::abs(x) > kLargest || (x != 0 && std::abs(x) < 1 / kLargest));
}

bool same(double a, double b) {
  if (!std::isfinite(a) || !std::isfinite(b)) return !std::isfinite(a) && !std::isfinite(b);
  return std::abs(a - b) <= kTolerance * std::max({1.0, std::abs(a), std::abs(b)});
}

bool same(const Answer& a, const Answer& b) {
  return a.thrown == b.thrown && a.numbers.size() == b.numbers.size() &&
         std::equal(a.numbers.data(), a.numbers.data() + a.numbers.size(), b.numbers.data(),
                    [](double x, double y) { return same(x, y); });
}

}  // namespace bounce::tests
