// What a run under AddressSanitizer and UBSan found, in a student's words.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace bounce::judge {

// From a sanitizer's name for a kind of error. Empty for any other text: a submission may have
// written it, and nothing that it writes is repeated here.
std::optional<std::string> words_for_report(std::string_view kind);

}  // namespace bounce::judge
