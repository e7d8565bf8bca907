// A failed case in numbers, for reports that draw it.
//
//   "name", "input", "sentence"   as in the message
//   "contact"    what the corner does, in words
//   "quantities" the wrong ones: {"name", "unit", "got", "right", "expected"}, matrices by rows;
//                "right" has a bool for each entry
//   "scene"      if a picture needs it: {"l", "m", "g", "dt", "delta", "q", "v"}
//   "path"       part 4: {"first", "got", "expected"}, configurations by column from 0 on
//                ("expected" only those of "columns"); first is the first wrong column
//
// A hidden case has no "contact", which would reveal the answer, and no "expected". A number that
// isn't finite is "nan", "inf" or "-inf".
#pragma once

#include <nlohmann/json.hpp>

#include "../../tests/parts/cases.hpp"

namespace bounce::judge {

nlohmann::json failed_case(const tests::Case& c, const tests::Problem& problem);

}  // namespace bounce::judge
