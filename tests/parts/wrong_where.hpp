// Finds what wrong cases have in common, and right ones don't have.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "answers.hpp"

namespace bounce::tests {

// The cases of part 3 with what the corner does by the right answers: a diagnostic question may
// differ in this from the case that it was made of.
std::vector<Case> named_by_answer(std::vector<Case> cases, const std::vector<Answer>& right);

// "Wrong only where ...", for the cases with these indices. Empty if all or too few are right, or
// if nothing sets the wrong ones apart.
std::string where(int part, const std::vector<Case>& cases, const std::set<std::size_t>& wrong);

}  // namespace bounce::tests
