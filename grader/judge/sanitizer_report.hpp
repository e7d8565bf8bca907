// Explains what AddressSanitizer and UBSan found, in words that a student knows.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace bounce::judge {

// The words for a sanitizer's name of an error. Empty for any other text, which a submission may
// have written, so that nothing of it is repeated.
std::optional<std::string> words_for_report(std::string_view kind);

}  // namespace bounce::judge
