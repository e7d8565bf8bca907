// Looks for undefined behaviour in a program that passes all checks.
#pragma once

#include <string>

namespace bounce::check {

struct Undefined {
  std::string found;      // what there is to mend, in a sentence; empty if nothing was found
  std::string not_asked;  // why nothing was looked for; empty if it was
};

// Builds all parts with sanitizers and runs the public checks with them, once after each change of
// the sources, and says so meanwhile.
Undefined undefined_behaviour();

}  // namespace bounce::check
