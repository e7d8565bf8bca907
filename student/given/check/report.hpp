// What a check prints: the parts with their points, the first thing to do, and the score.
#pragma once

#include "parts.hpp"

namespace bounce::check {

// Whether there is nothing to mend: all checks pass, and where those of all parts do, sanitizers
// find nothing.
bool report(const Run& run);

// Under the first thing to do, where that is an error of the compiler.
void print_what_does_not_compile(const Run& run);

}  // namespace bounce::check
