// What is found in a part's wrong answers: one function a file. Each gives true sentences of all
// answers, or none.
#pragma once

#include "wrong_numbers.hpp"

namespace bounce::tests {

using Answers = std::vector<Answer>;
using Cases = std::vector<Case>;

// formulas.cpp: "Your phi is y - l/2 in every question", and the like: a formula that gives all of
// a quantity's numbers where the right one doesn't. If two formulas do, both are named; if more do,
// none is. The formulas are those of formula_table.cpp, and of trajectory.cpp for part 4.
Words formulas(int part, const Cases& cases, const Answers& right, const Answers& got);
Words trajectory(const Cases& cases, const Answers& right, const Answers& got);

// wrong_corner.cpp, of part 1: "Corner 4 is never chosen", "Your answer is always that of corner
// 1", and the like. Empty if some answer is that of no corner, or if every answer is that of the
// lowest.
Words corners(const Cases& cases, const Answers& right, const Answers& got);

// wrong_rules.cpp: a sentence if one rule explains every wrong number (a factor, a difference, a
// constant, few digits); else up to two, each for a quantity with its own rule; else none.
Words rules(int part, const Cases& cases, const Wrong& wrong);

// A sentence if exchanged places explain every answer; else empty.
std::string exchanged(int part, const Answers& right, const Answers& got);

// wrong_parameters.cpp: "Where only l is changed, phi stays the same in your answers, and it should
// change": if it does so in all questions that differ in this number alone. Empty if every input
// counts as it should. Nothing is said of the quantities of which these formulas say what they are.
Words inputs(int part, const Cases& cases, const Answers& right, const Answers& got,
             const Words& formulas);

// Whether the same question, asked twice, gets two answers.
bool answers_differ_when_asked_again(const Cases& cases, const Answers& got);

// wrong_where.cpp: "Wrong only where ...", for the cases with these indices. Empty if all or too
// few are right, or if nothing sets the wrong ones apart.
std::string where(int part, const Cases& cases, const std::set<std::size_t>& wrong);

// The cases of part 3 with what the corner does by the right answers: a diagnostic question may
// differ in this from the case that it was made of.
Cases named_by_answer(Cases cases, const Answers& right);

}  // namespace bounce::tests
