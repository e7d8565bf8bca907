// The questions of a part, the right answers and the known mistakes, as the fixtures hold them.
#pragma once

#include <map>

#include "../../../grader/diagnosis/recognise.hpp"

namespace bounce::tests {

struct KnownPart {
  std::vector<Case> cases;
  KnownMistakes known;
};

inline const KnownPart& known_part(int number) {
  static std::map<int, KnownPart> parts;
  if (parts.count(number) == 0) {
    parts.emplace(number, KnownPart{questions(number), known_mistakes(number)});
  }
  return parts.at(number);
}

}  // namespace bounce::tests
