// What a submission says, as it goes into a message: one line of printable characters.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace bounce::judge {

// At most so many characters, with "..." behind what was cut. Line breaks and tabs become blanks;
// other controls, marks that change the direction of writing and what isn't UTF-8 become U+FFFD.
std::string sanitize_line(std::string_view text, std::size_t most);

}  // namespace bounce::judge
