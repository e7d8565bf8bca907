// Parts 3 and 4 written again, with a switch for nearly each known mistake, to test recognition in
// code other than the gallery's, and with two mistakes in one program.
#pragma once

#include <set>
#include <string>

#include "../../../grader/diagnosis/answers.hpp"

namespace bounce::tests {

// What a program with these mistakes answers. One that isn't known here changes nothing.
std::vector<Answer> answers_with(const std::set<std::string>& mistakes, int part,
                                 const std::vector<Case>& cases);

}  // namespace bounce::tests
