// Finds inputs that make no difference to a part's answers and should, or the reverse.
#pragma once

#include "wrong_numbers.hpp"

namespace bounce::tests {

// "Where only l is changed, phi stays the same in your answers, and it should change": if it does
// so in all questions that differ in this number alone. Empty if every input counts as it should.
// Nothing is said of the quantities of which these formulas say what they are.
Words inputs(int part, const std::vector<Case>& cases, const std::vector<Answer>& right,
             const std::vector<Answer>& got, const Words& formulas);

// Whether the same question, asked twice, gets two answers.
bool answers_differ_when_asked_again(const std::vector<Case>& cases,
                                     const std::vector<Answer>& got);

}  // namespace bounce::tests
