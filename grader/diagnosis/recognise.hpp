// Recognises known mistakes by a part's answers, and describes what no known mistake explains.
#pragma once

#include <string>
#include <vector>

#include "answers.hpp"
#include "tables.hpp"

namespace bounce::tests {

// A known mistake, and its answers to the part's questions.
struct Mistake {
  std::string name, title, sentence, hint;
  std::vector<int> equations;
  std::vector<std::string> checks;  // that it costs
  std::vector<Answer> answers;
};

struct KnownMistakes {
  int together;  // numbers of an answer that belong together, as numbers_together says
  std::vector<Answer> right;
  std::vector<Mistake> mistakes;
};

// Reads a part's known mistakes from its file in fixtures/public/mistakes. Throws std::exception if
// there is none, or it is invalid.
KnownMistakes known_mistakes(int part);

// The mistakes that explain the answers: none, one, or two together. One mistake must explain every
// answer of the part, including the right ones, and show in enough of them to be sure. A pair must
// explain every answer by one rule that combines the two, and each of them must show by itself in
// as many answers. In part 3 one mistake may also explain every v' alone, where the move of q is
// wrong in a way that isn't known. If several explanations fit, returns only what they have in
// common; and nothing if a number is garbage.
std::vector<Mistake> recognise(const KnownMistakes& known, const std::vector<Answer>& got);

// Up to five facts about all answers: which quantities are right and which wrong;
// which inputs make no difference and should, or the reverse; otherwise, in which cases they are
// wrong; and a formula or rule that gives every wrong number. Where numbers can't be meant, or
// one question gets two answers, that is said and no more. Empty if there is nothing to say, or if
// nothing is wrong. The cases are the questions of the part, in the order of the answers.
std::vector<Pattern> patterns(int part, const std::vector<Case>& cases,
                              const std::vector<Answer>& right, const std::vector<Answer>& got);

// What is said of a part's answers to its questions: the known mistakes of the public fixtures;
// where they explain nothing, the patterns.
struct Diagnosis {
  std::vector<Mistake> mistakes;
  std::vector<Pattern> patterns;
};
Diagnosis diagnosis(int part, const std::vector<Case>& cases, const std::vector<Answer>& got);

// {"mistakes": [{"name", "title", "sentence", "equations", "hint", "checks"}],
//  "patterns": [{"id", "words", "about"}]} as JSON in one line.
std::string facts(const Diagnosis& diagnosis);

// Whether no calculation of a part gives this number: memory that was never set may hold it.
bool is_garbage(double x);

// Whether two answers agree to 1e-9, absolute or relative. NaN and infinity agree with each other.
bool same(double a, double b);
bool same(const Answer& a, const Answer& b);

}  // namespace bounce::tests
