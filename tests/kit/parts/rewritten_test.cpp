// Is a mistake named, and nothing false said? In code other than the gallery's (parts 3 and 4),
// with rounding noise, and with two mistakes in one program. A wrong name is worse than none.
#include "rewritten.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <random>

#include "known_part.hpp"

namespace bounce::tests {
namespace {

constexpr int kParts[] = {1, 2, 3, 4}, kRewritten[] = {3, 4};

std::vector<Answer> answers_of(int part, const std::set<std::string>& mistakes) {
  return answers_with(mistakes, part, known_part(part).cases);
}

bool is_right(int part, const std::vector<Answer>& got) {
  return std::equal(got.begin(), got.end(), known_part(part).known.right.begin(),
                    [](const Answer& a, const Answer& b) { return same(a, b); });
}

// The names in the order of the alphabet: "a + b".
std::string text(const std::set<std::string>& names) {
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? "" : " + ") + name;
  return all;
}

std::string named(const KnownMistakes& known, const std::vector<Answer>& got) {
  std::set<std::string> names;
  for (const Mistake& m : recognise(known, got)) names.insert(m.name);
  return text(names);
}

// The known mistakes, of parts 3 and 4 those that Rewritten has.
std::vector<std::string> mistakes_of(int part) {
  std::vector<std::string> names;
  for (const Mistake& m : known_part(part).known.mistakes) {
    if (part < 3 || !is_right(part, answers_of(part, {m.name}))) names.push_back(m.name);
  }
  return names;
}

TEST(rewritten, EveryMistakeIsRecognisedInOtherCode) {
  std::size_t count = 0;
  for (const int part : kRewritten) {
    EXPECT_TRUE(is_right(part, answers_of(part, {}))) << part;
    for (const std::string& name : mistakes_of(part)) {
      EXPECT_EQ(named(known_part(part).known, answers_of(part, {name})), name);
      ++count;
    }
  }
  EXPECT_GE(count, 45U);
}

TEST(rewritten, EveryMistakeIsRecognisedThroughRoundingNoise) {
  std::mt19937_64 random(1);
  const auto noise = [&] { return 1e-12 * (static_cast<double>(random() >> 11) * 0x1p-52 - 1); };
  for (const int part : kParts) {
    for (const Mistake& m : known_part(part).known.mistakes) {
      std::vector<Answer> got = m.answers;
      for (Answer& answer : got) {
        for (double& x : answer.numbers) x += noise() * std::max(1.0, std::abs(x));
      }
      EXPECT_EQ(named(known_part(part).known, got), m.name);
    }
  }
}

// Programs whose numbers are also those of others, so that no one can tell: a square is the same
// when it is seen from its other side, two signs make one, two halves a whole, one mistake hides
// what another one shares with a third, and 1 - epsilon is epsilon for a half.
std::map<std::string, std::string> same_numbers() {
  std::ifstream file(BOUNCE_PARTS "/same_numbers.txt");
  std::map<std::string, std::string> all;
  for (std::string line; std::getline(file, line);) {
    const std::size_t at = line.find(" = ");
    all[line.substr(0, at)] = line.substr(at + 3);
  }
  return all;
}

TEST(rewritten, NoMistakeIsGivenAWrongNameBeforeItIsKnown) {
  const auto same = same_numbers();
  for (const int part : kParts) {
    for (const Mistake& m : known_part(part).known.mistakes) {
      KnownMistakes others = known_part(part).known;
      std::erase_if(others.mistakes, [&](const Mistake& other) { return other.name == m.name; });
      EXPECT_EQ(named(others, m.answers), same.count(m.name) > 0 ? same.at(m.name) : "") << m.name;
    }
  }
}

// Of parts that aren't rewritten, what two mistakes make if no number is wrong by both of them;
// else nothing.
std::vector<Answer> laid_over(const KnownMistakes& known, std::size_t i, std::size_t j) {
  std::vector<Answer> got = known.mistakes[i].answers;
  for (std::size_t k = 0; k < got.size(); ++k) {
    const Eigen::VectorXd &right = known.right[k].numbers,
                          &other = known.mistakes[j].answers[k].numbers;
    Eigen::VectorXd& numbers = got[k].numbers;
    if (numbers.size() != right.size() || other.size() != right.size()) return {};
    for (Eigen::Index n = 0; n < right.size(); ++n) {
      if (other(n) == right(n)) continue;
      if (numbers(n) != right(n)) return {};
      numbers(n) = other(n);
    }
  }
  return got;
}

// One name is enough if the other mistake doesn't show.
TEST(rewritten, NoPairIsGivenAWrongName) {
  constexpr int kLeastNamed[] = {45, 460, 190, 30};
  const auto same = same_numbers();
  for (const int part : kParts) {
    const KnownMistakes& known = known_part(part).known;
    const std::vector<std::string> names = mistakes_of(part);
    int as_both = 0;
    for (std::size_t i = 0; i < names.size(); ++i) {
      for (std::size_t j = i + 1; j < names.size(); ++j) {
        const std::set<std::string> pair{names[i], names[j]};
        const std::string got =
            named(known, part < 3 ? laid_over(known, i, j) : answers_of(part, pair));
        const std::set<std::string> true_of_it{"", names[i], names[j], text(pair)};
        const bool same_as_others = same.count(text(pair)) > 0 && same.at(text(pair)) == got;
        EXPECT_TRUE(same_as_others || true_of_it.count(got) > 0) << text(pair) << " is " << got;
        as_both += got == text(pair);
      }
    }
    EXPECT_GE(as_both, kLeastNamed[part - 1]) << "part " << part;
  }
}

}  // namespace
}  // namespace bounce::tests
