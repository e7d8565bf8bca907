// A failed check as facts, which the judge prints, and a student's own build writes for ./check.
//
// "failure" is the wrong case to report, or the one at which the program ended:
//   "cases", "wrong"   how many the check has, and how many are wrong
//   "ended_at"   how many cases were asked until the program ended, 0 if it didn't
//   "again"      whether all were right when they were asked before, in another order
//   "always_zero"   whether each case is wrong, and every wrong number is 0
//   "name", "hidden"   of the case
//   "input", "parameters"   what is asked, and the parameters that aren't the assignment's:
//                {"name", "rows", "unit"}
//   "sentence"   what the numbers alone don't say, such as an exception's text
//   "quantities" the wrong ones: {"name", "unit", "got", "right"}, matrices by rows; "right" has a
//                bool for each entry
// "answer" is what is right: {"contact", "expected"}, what the corner does, and a matrix for each
// quantity. If the case is hidden, students must not see it.
//
// "smallest" is the simplest wrong case, for paper, or null:
//   "before"     what is asked before it, where that matters, as "input"; else null
//   "input"      {"q", "v" or "J", "params": those that aren't the assignment's}
//   "quantity", "unit", "expected", "got"   the first wrong quantity, as matrices by rows
//   "on_the_way" right, too: {"name", "rows", "unit", "equation"}
//
// A number that isn't finite is "nan", "inf" or "-inf".
#pragma once

#include <string>

#include "failed_case.hpp"

namespace bounce::tests {

// {"failure": ..., "answer": ..., "smallest": ...} as JSON in one line.
std::string facts(const words::FailedCase& failed);

}  // namespace bounce::tests
