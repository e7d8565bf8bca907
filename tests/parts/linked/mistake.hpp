// Describes the mistakes of the linked part, in addition to its failed checks.
#pragma once

#include <string>

namespace bounce::tests {

// One paragraph per line: the known mistakes that the answers to the public cases point to; or, if
// there are none, the patterns in the numbers. Empty if there is nothing to say.
std::string mistakes_in_words();

}  // namespace bounce::tests
