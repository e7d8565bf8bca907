// A failed check in numbers: its first wrong case, or the one at which the program ended.
//
//   "cases", "wrong"   how many the check has, and how many are wrong
//   "ended_at"   how many cases were asked until the program ended, 0 if it didn't
//   "again"      whether all were right when they were asked before, in another order
//   "name", "input", "hidden"   of the case; its input in words
//   "contact"    what the corner does, in words
//   "sentence"   what the numbers alone don't say, such as an exception's text
//   "quantities" the wrong ones: {"name", "unit", "got", "right", "expected"}, matrices by rows;
//                "right" has a bool for each entry
//
// "contact" and "expected" would tell the answer to a hidden case. A number that isn't finite is
// "nan", "inf" or "-inf".
#pragma once

#include <nlohmann/json.hpp>

#include "../../tests/parts/checks.hpp"
#include "termination.hpp"

namespace bounce::judge {

nlohmann::json facts(const tests::Failure& failure);

// How a program ended: {"what", "number", "text"}.
inline nlohmann::json facts(const Termination& end) {
  return {{"what", end.what}, {"number", end.number}, {"text", end.text}};
}

}  // namespace bounce::judge
