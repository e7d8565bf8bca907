// Sentences that are read from files, so that they can be read, and corrected, in one sitting.
//
// In such a file, what a sentence is said of stands indented below it, with " | " between: ids, or
// pieces of other programs' texts.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace bounce::words {

// An id or a piece, and its sentence.
using Sentences = std::vector<std::pair<std::string, std::string>>;

// Reads a file once, from the folder of sentences_folder. Throws std::runtime_error without it.
const Sentences& sentences(const std::string& file);
inline std::filesystem::path sentences_folder = "given/words";  // as the handout has it

// The sentence of the id; empty if there is none.
std::string sentence_of(const std::string& file, const std::string& id);

// The sentence of the first piece that the text holds; empty if it holds none.
std::string meaning_in(const std::string& file, const std::string& text);

// The sentence with each {name} replaced.
std::string filled(std::string sentence,
                   const std::vector<std::pair<std::string, std::string>>& values);

// One line, without the blanks that could make a terminal begin another, cut to `most` bytes, and
// not in a character. What isn't UTF-8 or doesn't print is replaced where it is read.
std::string one_line(const std::string& text, std::size_t most = 120);

}  // namespace bounce::words
