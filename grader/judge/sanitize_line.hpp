// Makes one line of a submission's text, for a message.
#pragma once

#include <string>
#include <string_view>

namespace bounce::judge {

// Cuts the text to `most` bytes, not within a character, and marks the cut by "..."; line breaks
// and tabs become blanks. What isn't UTF-8 is replaced when it is printed (main.cpp), and what
// doesn't print where it is read (common/escaping.py).
inline std::string sanitize_line(std::string_view text, std::size_t most) {
  const bool cut = text.size() > most;
  if (cut) {
    while (most > 0 && (static_cast<unsigned char>(text[most]) & 0xC0) == 0x80) --most;
    text = text.substr(0, most);
  }
  std::string line(text);
  for (char& sign : line) {
    if (sign == '\n' || sign == '\r' || sign == '\t') sign = ' ';
  }
  return cut ? line + "..." : line;
}

}  // namespace bounce::judge
