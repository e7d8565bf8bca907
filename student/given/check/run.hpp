// Runs the checks of the parts, each part in a process of its own.
#pragma once

#include <string>

#include "parts.hpp"

namespace bounce::check {

// Runs the chosen parts that are built, adds up the points, and finds the first thing to do. A part
// that loses points and calls wrong earlier ones is run again with recorded right answers in place
// of theirs; the better result counts, as in the course's grading.
void run_parts(Run& run);

// The status of a check that can't be decided before the earlier parts are right: the recorded
// answers that stand for theirs were asked something else.
constexpr const char* kUndecided = "undecided";

// What is known of a check.
struct Note {
  std::string status;            // passed, failed, crashed, hung, kUndecided; unknown if not run
  std::size_t from = 0, to = 0;  // bytes of what the program printed, around the case
  bool has_prints = false;       // whether these are known
  std::string text;              // what there is to say
};
Note note_of(const Part& part, const Check& check);

// What the part's checks that pass are worth; and those that are undecided.
int points_of(const Part& part);
int undecided_of(const Run& run, const Part& part);

// The file with all that a part's program printed.
std::string prints_file(int part);

// What the answers to all public cases tell of the mistake, a paragraph a line. Empty if they tell
// nothing, or if the part's program crashes or hangs.
std::string mistake_of(const Run& run, const Part& part);

}  // namespace bounce::check
