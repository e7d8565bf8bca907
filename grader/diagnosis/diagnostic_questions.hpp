// Questions that are asked of a wrong part beside its public cases. They tell mistakes apart that
// answer the public cases alike.
#pragma once

#include <vector>

#include "cases.hpp"

namespace bounce::tests {

// Variations of the public cases of a part: a parameter changed alone, quarter turns, a corner near
// delta. Only the questions are valid: what is expected is left as it was.
std::vector<Case> diagnostic_questions(int part, const std::vector<Case>& cases);

}  // namespace bounce::tests
