// What a run under AddressSanitizer and UBSan found, in a student's words.
#pragma once

#include <string>

namespace bounce::judge {

// From a sanitizer's name of an error, or its message.
std::string what_was_found(const std::string& finding);

}  // namespace bounce::judge
