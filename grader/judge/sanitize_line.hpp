// Turns a submission's text into one line of printable characters for a message.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace bounce::judge {

// Cuts the text to `most` characters and marks the cut by "...". Line breaks and tabs become
// blanks; other control characters, bidirectional marks and invalid UTF-8 become U+FFFD.
std::string sanitize_line(std::string_view text, std::size_t most);

}  // namespace bounce::judge
