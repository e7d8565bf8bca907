// Which hint helps with a failed check: a section of hints/STEM.md, whose lines name what it is
// for.
//
//   Checks: part1.GivesTheNormalColumn      the ids of checks
//   Diagnoses: J_by_rows; where(l)          the ids of patterns; in brackets, what one is about
//   alone Numbers: J_t_arm; J_n_arm               likewise, but only for the section's own checks:
//   these
//                                           patterns are about the numbers that they compare
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace bounce::words {

// A fact about all of a part's wrong answers: the id of its row in tables.txt, the words for the
// row's sentence, and what it is about, such as an input's name.
struct Pattern {
  std::string id;
  std::vector<std::string> words = {}, about = {};
};

struct Hint {
  std::string heading;  // "1.2 The moment arm r"
  std::string nudge;    // its first stage, a paragraph of plain text
};

inline std::filesystem::path hints_folder = "hints";  // as the handout has it

// The hint for the first pattern that a section names, else that for the check; empty if there is
// none.
Hint hint_of(const std::string& stem, const std::string& check,
             const std::vector<Pattern>& patterns = {});

// The one with this heading.
Hint hint_named(const std::string& stem, const std::string& heading);

}  // namespace bounce::words
