// Explains what AddressSanitizer and UBSan found, in words that a student knows; for ./check and
// the course's judge alike.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace bounce::check {

// What is said where `auto` is why a value is used that is gone.
inline constexpr char kAutoKeeps[] =
    "`auto` keeps an expression of Eigen that refers to a value which is gone by the next line; "
    "write `Eigen::Matrix3d`, or the type that it has";

// The words for a sanitizer's name of an error. Empty for any other text, which a submission may
// have written, so that nothing of it is repeated.
std::optional<std::string> words_for_report(std::string_view kind);

}  // namespace bounce::check
