// The feedback on a failed public case in a student's own build: numbers side by side, and a
// picture.
#pragma once

#include "cases.hpp"

namespace bounce::tests {

// What the corner does; each wrong quantity beside the right one, with wrong entries marked; and
// for parts 3 and 4 a picture. For a hidden case, only the summary.
std::string feedback(const Case& c, const Problem& problem);

}  // namespace bounce::tests
