// A failed case in numbers, for reports that draw it.
//
//   "name", "input", "sentence"   as in the message
//   "contact"    what the corner does, in words
//   "quantities" what came out wrong: {"name", "unit", "got", "right", "expected"}, matrices by
//                rows; "right" says of each entry whether it is
//   "scene"      where a picture needs it: {"l", "m", "g", "dt", "delta", "q", "v"}
//   "path"       part 4: {"first", "got", "expected"}, a configuration each column from 0 on (the
//                expected one of "columns" alone); first is the first wrong column
//
// Of a hidden case there is no "contact", which tells the answer, and nothing that is expected. A
// number that isn't finite is "nan", "inf" or "-inf".
#pragma once

#include <nlohmann/json.hpp>

#include "../../tests/parts/cases.hpp"

namespace bounce::judge {

nlohmann::json failed_case(const tests::Case& c, const tests::Problem& problem);

}  // namespace bounce::judge
