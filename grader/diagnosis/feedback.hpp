// The feedback on a failed public case in a student's own build: numbers side by side.
#pragma once

#include "cases.hpp"

namespace bounce::tests {

// What the corner does; and each wrong quantity beside the right one, with wrong entries marked.
// For a hidden case, only the summary.
std::string feedback(const Case& c, const Problem& problem);

}  // namespace bounce::tests
