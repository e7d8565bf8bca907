#include "mistake.hpp"

#include <fstream>

#include "linked.hpp"
#include "pattern.hpp"
#include "recognise.hpp"

namespace bounce::tests {
namespace {

std::string numbered(const std::vector<int>& equations) {
  std::string text = equations.size() == 1 ? "eq. " : "eqs. ";
  for (std::size_t i = 0; i < equations.size(); ++i) {
    text += (i == 0 ? "(" : ", (") + std::to_string(equations[i]) + ")";
  }
  return text;
}

std::string in_words(const std::vector<Mistake>& mistakes) {
  std::string text = mistakes.size() == 2 ? "This looks like two known mistakes at once.\n"
                                          : "This looks like a known mistake.\n";
  for (const Mistake& m : mistakes) {
    text += m.title + ". " + m.sentence + " See " + numbered(m.equations) + " and hint " + m.hint +
            ".\n";
  }
  return text;
}

std::string told(int part) {
  const auto file = public_file(part, "mistakes");
  if (!file) return "";
  std::ifstream in(*file);
  const KnownMistakes known = read_mistakes(in, part);
  const std::vector<Case> cases = questions(part);
  const std::vector<Answer> got = answers(part, cases);
  const std::vector<Mistake> mistakes = recognise(known, got);
  if (!mistakes.empty()) return in_words(mistakes);
  std::string text;
  for (const auto& sentence : patterns(part, cases, known.right, got)) text += sentence + "\n";
  return text;
}

}  // namespace

std::string mistakes_in_words() {
  std::string text;
  for (const char part : linked().parts) text += told(part - '0');
  return text;
}

}  // namespace bounce::tests
