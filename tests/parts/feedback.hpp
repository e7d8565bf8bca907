// A failed public case as a student at work is told it: numbers side by side, and a picture.
#pragma once

#include "cases.hpp"

namespace bounce::tests {

// What the corner does, then each wrong quantity beside the right one with the wrong entries
// marked, and for parts 3 and 4 a picture. No more than the summary where the case is hidden.
std::string feedback(const Case& c, const Problem& problem);

}  // namespace bounce::tests
