// The interface of the fuzzers, each of which tests one reader of the judge on arbitrary bytes.
// With driver.cpp, it takes those that test_readers.py makes; with libFuzzer (cmake --preset fuzz),
// its own.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "../../../grader/judge/termination.hpp"
#include "../../../grader/words/sentences.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace bounce::fuzz {

// Real inputs, to be mutated.
std::vector<std::string> seeds();

// Ends the program if a promise is broken, so that the input is kept.
inline void require(bool promise) {
  if (!promise) __builtin_trap();
}

// One line of bounded length.
inline bool is_one_line(const std::string& text) {
  return !text.empty() && words::one_line(text, 800) == text;
}

}  // namespace bounce::fuzz
