// What is told of the mistakes of the part that is linked in, beside its failed checks.
#pragma once

#include <string>

namespace bounce::tests {

// A paragraph a line: the known mistakes that the answers to the public cases tell of; else what
// the numbers say by themselves. Empty where there is nothing to say.
std::string mistakes_in_words();

}  // namespace bounce::tests
