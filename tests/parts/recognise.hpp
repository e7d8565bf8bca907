// Known mistakes, and which of them a part's answers tell of.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "answers.hpp"

namespace bounce::tests {

// What is known of a mistake, and what it answers to the part's questions.
struct Mistake {
  std::string name, title, sentence, hint;
  std::vector<int> equations;
  std::vector<Answer> answers;
};

struct KnownMistakes {
  int together;  // numbers of an answer that belong together, as numbers_together says
  std::vector<Answer> right;
  std::vector<Mistake> mistakes;

  // Whether both of a pair have to show by themselves. In part 1 they have to: its numbers are made
  // of three alone, r_x, r_y and phi, so that two mistakes at one place are easily two others.
  bool each_by_itself = false;
};

// Those of a part, from its file in fixtures/public/mistakes. Throws std::exception where it isn't
// one.
KnownMistakes read_mistakes(std::istream& file, int part);

// None, one, or two that the answers are a mixture of. A mistake is named when it explains every
// answer of the part, the right ones among them, and shows in enough of them to be sure; a pair,
// when one rule for all entries composes the two, one of them shows by itself in as many, and so
// does the other, or it makes a difference there. Of explanations that say different things, only
// what they have in common is said.
std::vector<Mistake> recognise(const KnownMistakes& known, const std::vector<Answer>& got);

// Whether two answers are the same: 1e-9, absolute or relative. NaN and infinity are one.
bool same(double a, double b);
bool same(const Answer& a, const Answer& b);

}  // namespace bounce::tests
