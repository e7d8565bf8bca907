#include "recognise.hpp"

#include <algorithm>
#include <climits>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <stdexcept>

namespace bounce::tests {
namespace {

using Eigen::Index;
using json = nlohmann::ordered_json;  // as in cases.cpp, so that it is compiled once
using Answers = std::vector<Answer>;

constexpr double kTolerance = 1e-9;

// A number agrees by chance once in a billion. But many mistakes, such as a constant or a branch,
// can cause the same wrong number, or the same wrong answer to one question. So a mistake must show
// in at least four numbers, and in two questions or columns of a trajectory.
constexpr int kNumbers = 4, kQuestions = 2;

// --- reading ---

double number(const json& x) { return x.is_null() ? std::nan("") : x.get<double>(); }

Answer read_answer(const json& words) {
  Answer answer{Eigen::VectorXd(static_cast<Index>(words.size())), ""};
  for (Index i = 0; i < answer.numbers.size(); ++i) {
    answer.numbers(i) = number(words.at(static_cast<std::size_t>(i)));
  }
  return answer;
}

// Reads the wrong answers, {question: {entry: number}} or {question: text of an exception}, and
// fills in the right ones.
Answers read_differences(const json& differences, Answers answers) {
  for (const auto& [question, words] : differences.items()) {
    Answer& answer = answers.at(std::stoul(question));
    if (words.is_string()) {
      answer = {{}, words.get<std::string>()};
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

// Whether a mistake shows often enough by itself: its number is wrong, and the other answer's is
// right. Numbers that aren't finite don't count, since they have many causes.
bool shows(const Answers& mistaken, const Answers& other, const KnownMistakes& known,
           Index first = 0) {
  int numbers = 0;
  std::set<std::pair<std::size_t, Index>> questions;
  for (std::size_t k = 0; k < mistaken.size(); ++k) {
    const Answer &a = mistaken[k], &b = other[k], &right = known.right[k];
    if (!b.thrown.empty()) continue;
    if (!a.thrown.empty()) {
      ++numbers;
      questions.insert({k, 0});
    }
    for (Index i = first; i < a.numbers.size(); ++i) {
      const double x = right.numbers(i);
      if (!std::isfinite(a.numbers(i)) || same(a.numbers(i), x) || !same(b.numbers(i), x)) continue;
      ++numbers;
      questions.insert({k, i / known.together});
    }
  }
  return numbers >= kNumbers && static_cast<int>(questions.size()) >= kQuestions;
}

// Whether two answers agree, in the numbers from `first` to before `end`.
bool agree(const Answer& a, const Answer& b, Index first = 0, Index end = INT_MAX) {
  bool are_same = a.thrown == b.thrown && a.numbers.size() == b.numbers.size();
  for (Index i = first; are_same && i < std::min(end, a.numbers.size()); ++i) {
    are_same = same(a.numbers(i), b.numbers(i));
  }
  return are_same;
}

bool all_agree(const Answers& some, const Answers& others, Index first, Index end = INT_MAX) {
  return std::equal(some.begin(), some.end(), others.begin(),
                    [&](const Answer& a, const Answer& b) { return agree(a, b, first, end); });
}

// --- composing ---

// The value of an entry that two mistakes a and b both change.
using Rule = double (*)(double right, double a, double b);
constexpr Rule kRules[] = {
    [](double right, double a, double b) { return right + (a - right) + (b - right); },
    [](double right, double a, double b) { return right == 0 ? NAN : a * (b / right); },
};

// The answer with both mistakes. If one of them throws, there are no numbers, so the other doesn't
// show; nothing if they throw different texts.
std::optional<Answer> composed(const Answer& right, const Answer& a, const Answer& b, Rule rule) {
  if (!a.thrown.empty() && !b.thrown.empty() && a.thrown != b.thrown) return std::nullopt;
  if (!a.thrown.empty() || !b.thrown.empty()) return a.thrown.empty() ? b : a;
  Answer both = right;
  for (Index i = 0; i < right.numbers.size(); ++i) {
    const double x = right.numbers(i), of_a = a.numbers(i), of_b = b.numbers(i);
    both.numbers(i) = same(of_a, x) ? of_b : same(of_b, x) ? of_a : rule(x, of_a, of_b);
  }
  return both;
}

// Whether both together explain the answers, and each of the two shows by itself. One that shows
// only where the other does may as well be the half of a third mistake.
bool explain(const KnownMistakes& known, const Mistake& a, const Mistake& b, Rule rule,
             const Answers& got) {
  for (std::size_t k = 0; k < got.size(); ++k) {
    const auto both = composed(known.right[k], a.answers[k], b.answers[k], rule);
    if (!both || !same(*both, got[k])) return false;
  }
  return shows(a.answers, b.answers, known) && shows(b.answers, a.answers, known);
}

using Names = std::set<std::size_t>;  // of mistakes, by index

// The mistakes that explain each number from the first one on, and change none before it.
std::vector<Names> singles(const KnownMistakes& known, const Answers& got, Index first = 0) {
  std::vector<Names> found;
  for (std::size_t i = 0; i < known.mistakes.size(); ++i) {
    const Answers& mistaken = known.mistakes[i].answers;
    if (all_agree(mistaken, got, first) &&
        (first == 0 || all_agree(mistaken, known.right, 0, first))) {
      found.push_back({i});
    }
  }
  return found;
}

std::vector<Names> pairs(const KnownMistakes& known, const Answers& got) {
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

// The mistakes in v' alone that explain every v' of part 3. q' is wrong in another way.
std::vector<Names> singles_of_velocity(const KnownMistakes& known, const Answers& got) {
  const auto is_a_state = [](const Answer& a) { return a.thrown.empty() && a.numbers.size() == 6; };
  const bool are_states = std::all_of(got.begin(), got.end(), is_a_state) &&
                          std::all_of(known.right.begin(), known.right.end(), is_a_state);
  return are_states && shows(got, known.right, known, 3) ? singles(known, got, 3)
                                                         : std::vector<Names>();
}

Names in_common(const std::vector<Names>& explanations) {
  Names common = explanations.empty() ? Names() : explanations.front();
  for (const Names& names : explanations) {
    std::erase_if(common, [&](std::size_t i) { return names.count(i) == 0; });
  }
  return common;
}

}  // namespace

KnownMistakes known_mistakes(int part) {
  std::ifstream file(public_file(part, "mistakes"));
  const json all = json::parse(file);
  KnownMistakes known{numbers_together(part), {}, {}};
  for (const json& answer : all.at("right")) known.right.push_back(read_answer(answer));
  for (const json& m : all.at("mistakes")) {
    known.mistakes.push_back({m.at("name"), m.at("title"), m.at("sentence"), m.at("hint"),
                              m.at("equations").get<std::vector<int>>(),
                              m.at("checks").get<std::vector<std::string>>(),
                              read_differences(m.at("answers"), known.right)});
  }
  return known;
}

std::vector<Mistake> recognise(const KnownMistakes& known, const std::vector<Answer>& got) {
  if (got.size() != known.right.size() || !shows(got, known.right, known)) return {};
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

std::string facts(const Diagnosis& diagnosis) {
  json all = {{"mistakes", json::array()}, {"patterns", json::array()}};
  for (const Mistake& m : diagnosis.mistakes) {
    all["mistakes"].push_back({{"name", m.name},
                               {"title", m.title},
                               {"sentence", m.sentence},
                               {"equations", m.equations},
                               {"hint", m.hint},
                               {"checks", m.checks}});
  }
  for (const auto& [id, words, about] : diagnosis.patterns)
    all["patterns"].push_back({{"id", id}, {"words", words}, {"about", about}});
  return all.dump();
}

bool is_garbage(double x) {
  constexpr double kLargest = 1e290;
  return std::isfinite(x) && (std::abs(x) > kLargest || (x != 0 && std::abs(x) < 1 / kLargest));
}

bool same(double a, double b) {
  if (!std::isfinite(a) || !std::isfinite(b)) return !std::isfinite(a) && !std::isfinite(b);
  return std::abs(a - b) <= kTolerance * std::max({1.0, std::abs(a), std::abs(b)});
}

bool same(const Answer& a, const Answer& b) { return agree(a, b); }

}  // namespace bounce::tests
