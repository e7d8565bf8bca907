#include "sanitize_line.hpp"

#include <array>

namespace bounce::judge {
namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";  // U+FFFD

unsigned byte(std::string_view text, std::size_t i) { return static_cast<unsigned char>(text[i]); }

// The length in bytes of a character with this first byte; 0 if no character begins so.
std::size_t length_from(unsigned first) {
  if (first < 0x80) return 1;
  if (first >= 0xC2 && first < 0xE0) return 2;
  if (first >= 0xE0 && first < 0xF0) return 3;
  return first >= 0xF0 && first < 0xF5 ? 4 : 0;
}

// The first character of a text: its bytes and its code point; no bytes if it isn't UTF-8.
struct Character {
  std::string_view bytes;
  unsigned number = 0;
};

Character first_of(std::string_view text) {
  static constexpr std::array<unsigned, 5> kLeast = {0, 0, 0x80, 0x800, 0x10000};
  const std::size_t length = length_from(byte(text, 0));
  if (length == 0 || length > text.size()) return {};
  if (length == 1) return {text.substr(0, 1), byte(text, 0)};
  unsigned number = byte(text, 0) & (0xFFu >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(text, i) & 0xC0) != 0x80) return {};
    number = number << 6 | (byte(text, i) & 0x3F);
  }
  const bool surrogate = number >= 0xD800 && number < 0xE000;
  if (number < kLeast[length] || number > 0x10FFFF || surrogate) return {};
  return {text.substr(0, length), number};
}

bool prints(unsigned number) {
  const auto between = [number](unsigned a, unsigned b) { return number >= a && number <= b; };
  return !(number < 0x20 || between(0x7F, 0x9F) || number == 0xAD || between(0x200B, 0x200F) ||
           between(0x2028, 0x202E) || between(0x2060, 0x206F) || number == 0xFEFF ||
           between(0xFFF0, 0xFFFB) || (number & 0xFFFE) == 0xFFFE || between(0xE0000, 0xE0FFF));
}

}  // namespace

std::string sanitize_line(std::string_view text, std::size_t most) {
  std::string line;
  for (std::size_t count = 0; !text.empty(); ++count) {
    if (count == most) return line + "...";
    const Character c = first_of(text);
    if (c.number == '\n' || c.number == '\t' || c.number == '\r') {
      line += ' ';
    } else {
      line += !c.bytes.empty() && prints(c.number) ? c.bytes : kReplacement;
    }
    text.remove_prefix(c.bytes.empty() ? 1 : c.bytes.size());
  }
  return line;
}

}  // namespace bounce::judge
