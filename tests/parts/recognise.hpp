// Recognises known mistakes by a part's answers.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "answers.hpp"

namespace bounce::tests {

// A known mistake, and its answers to the part's questions.
struct Mistake {
  std::string name, title, sentence, hint;
  std::vector<int> equations;
  std::vector<Answer> answers;
};

struct KnownMistakes {
  int together;  // numbers of an answer that belong together, as numbers_together says
  std::vector<Answer> right;
  std::vector<Mistake> mistakes;

  // Whether both of a pair must show by themselves. In part 1 they must: all of its numbers are
  // made of r_x, r_y and phi, so that two mistakes in the same one often look like two others.
  bool each_by_itself = false;
};

// Reads a part's known mistakes from its file in fixtures/public/mistakes. Throws std::exception if
// the file is invalid.
KnownMistakes read_mistakes(std::istream& file, int part);

// The mistakes that explain the answers: none, one, or two together. One mistake must explain every
// answer of the part, including the right ones, and show in enough of them to be sure. A pair must
// explain every answer by one rule that combines the two; one of them must show by itself in as
// many answers, and the other must, too, or must at least change something. If several explanations
// fit, returns only what they have in common.
std::vector<Mistake> recognise(const KnownMistakes& known, const std::vector<Answer>& got);

// Whether two answers agree to 1e-9, absolute or relative. NaN and infinity agree with each other.
bool same(double a, double b);
bool same(const Answer& a, const Answer& b);

}  // namespace bounce::tests
