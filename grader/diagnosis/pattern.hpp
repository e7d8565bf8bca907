// Describes patterns in wrong answers that no known mistake explains.
#pragma once

#include <string>
#include <vector>

#include "answers.hpp"

namespace bounce::tests {

// Up to five sentences, each a fact about all answers: which quantities are right and which wrong;
// which inputs make no difference and should, or the reverse; otherwise, in which cases they are
// wrong; and a formula or rule that gives every wrong number. Where numbers can't be meant, or
// one question gets two answers, that is said and no more. Empty if there is nothing to say, or if
// nothing is wrong. The cases are the questions of the part, in the order of the answers.
std::vector<std::string> patterns(int part, const std::vector<Case>& cases,
                                  const std::vector<Answer>& right, const std::vector<Answer>& got);

}  // namespace bounce::tests
