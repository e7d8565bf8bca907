// What a report says of a part: facts in, sentences out, for ./kit grade and for ./check.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ending.hpp"
#include "failed_case.hpp"
#include "hints.hpp"

namespace bounce::words {

// Something that there is to say: the id of its sentence in report.txt, and the words in it.
struct Fact {
  std::string id;
  std::vector<std::string> words;
};

struct CheckFacts {
  std::string id, title, status;
  bool passed = false;
  std::optional<Ending> ended;
  std::optional<FailedCase> failed;
  std::string place;  // "part1_contacts.cpp:12", where it crashed; empty if unknown
  std::string found;  // sanitizers' name for what they found there; empty if nothing
};

struct MistakeFacts {
  std::string title, sentence, hint;
  std::vector<int> equations;
  std::vector<std::string> checks;  // that it costs
};

struct PartFacts {
  std::string stem, status;
  std::optional<Fact> why;  // nothing could be run
  std::vector<Fact> notes;  // what else explains the points
  std::vector<MistakeFacts> mistakes;
  std::vector<Pattern> patterns;
  std::vector<CheckFacts> checks;
};

struct SaidCheck {
  std::string message;                      // in lines; empty if it passed or never ran
  bool refers = false;                      // to another check, in place of its case
  Hint hint = {};                           // empty if it passed
  std::optional<std::size_t> mistake = {};  // the one to name for it
};

struct SaidPart {
  std::string message;
  std::vector<SaidCheck> checks = {};
};

// The hint for the first check that fails: that of the mistake which costs it, or of what the wrong
// numbers say, or of the check.
Hint first_hint(const PartFacts& part, const std::string& check);

// With `reveal`, what is right of hidden cases is said, as far as the facts have it.
SaidPart say(const PartFacts& part, bool reveal);

// "eq. (6) and hint 1.2 The moment arm r"
std::string where_to_read(const MistakeFacts& mistake);

std::string sentence_of(const Fact& fact);

}  // namespace bounce::words
