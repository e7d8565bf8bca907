// Looks for undefined behaviour in a program that passes all checks.
#pragma once

#include <string>

namespace bounce::check {

// What there is to fix, in a sentence; empty if nothing was found. Builds all parts with sanitizers
// and runs the public checks with them, once after each change of the sources, and says so
// meanwhile. Throws Failure where that can't be done.
std::string undefined_behaviour();

}  // namespace bounce::check
