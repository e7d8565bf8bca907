// One input for a reader of the judge's, whatever its bytes are. Each program of this folder is a
// reader: with driver.cpp it takes a few thousand mutations of its seeds, the same each time; with
// libFuzzer (cmake --preset fuzz) as many as one likes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "../../../grader/judge/sanitize_line.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace bounce::fuzz {

// Real inputs, to be changed.
std::vector<std::string> seeds();

// Ends the program, so that the input is kept, where something isn't as promised.
inline void require(bool promise) {
  if (!promise) __builtin_trap();
}

// One line that can be shown anywhere, of bounded length. Counted in characters, since where a byte
// wasn't text, one of three bytes stands for it.
inline bool is_sentence(const std::string& text) {
  return !text.empty() && judge::sanitize_line(text, 600) == text;
}

}  // namespace bounce::fuzz
