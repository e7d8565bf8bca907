// Finds inputs that make no difference to a part's answers and should, or the reverse.
#pragma once

#include "wrong_numbers.hpp"

namespace bounce::tests {

// "Where only l is changed, phi stays the same in your answers, and it should change": from
// questions that differ in one number alone, and from the same question asked twice. Empty if every
// input counts as it should.
Words inputs(int part, const std::vector<Case>& cases, const std::vector<Answer>& right,
             const std::vector<Answer>& got);

}  // namespace bounce::tests
