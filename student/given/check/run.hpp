// The parts and their checks, as tests/checks.txt says; what builds and runs them, and what comes
// out.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "words.hpp"

namespace bounce::check {

struct Check {
  std::string id, title;
  int points = 0;
};

// The status of a check that can't be decided before the earlier parts are right: the recorded
// answers that stand for theirs were asked something else.
inline constexpr const char* kUndecided = "undecided";
// Of one that passed as far as these answers decide it.
inline constexpr const char* kOpen = "open";
// How one ended that wasn't run any more (given/words/endings.txt).
inline constexpr const char* kNotAsked = "not asked as it hung";

// What is known of a check.
struct Note {
  std::string status = "unknown";   // passed, failed, crashed, hung, kUndecided; unknown if not run
  std::string text{};               // what there is to say
  std::size_t from = 0;             // bytes of what the program printed, around the case
  std::optional<std::size_t> to{};  // empty where these aren't known
  std::string facts{};              // of a case that failed, as JSON (facts.hpp)
  std::optional<words::Ending> ended{};  // how the program ended in it
  std::string place{};                   // and where, "src/part3_step.cpp:12"
};

// Of a program that ran a part's checks.
struct Result {
  std::string program, prints;          // the files: itself, and all that it printed
  std::map<std::string, Note> notes{};  // by the id of the check

  Note note(const Check& check) const {
    const auto found = notes.find(check.id);
    return found == notes.end() ? Note{} : found->second;
  }
};

struct Part {
  int number = 0;
  std::string stem, title;
  int points = 0;
  std::vector<int> calls{};  // earlier parts
  std::vector<Check> checks{};
  // Of this run:
  const Part* broken = nullptr;  // where it isn't built: the part whose file has the error
  BuildError error{};            // the first in its own file
  bool is_given = false;         // its better result is that with right earlier parts
  Result result{}, own{};  // the better one; and where that is so, that with the student's own

  std::string file() const { return "src/" + stem + ".cpp"; }
  // What the checks are worth that have this status.
  int worth(const std::string& status = "passed") const;
  int undecided() const { return worth(kUndecided); }
};

struct Run {
  std::vector<Part> all{};
  std::vector<Part*> chosen{};         // the parts to check
  bool sanitized = false;              // whether the parts are built with sanitizers
  int score = 0, possible = 0;         // of the chosen parts
  int undecided = 0;                   // points of checks that wait for right earlier parts
  const Part* first_part = nullptr;    // where the first thing to do is, if there is one
  const Check* first_check = nullptr;  // null where that part isn't built
  // A part that scores better with right earlier parts than with the student's, though these pass
  // their own checks; and what its first check that fails says with the student's.
  const Part* fault_shows_in = nullptr;
  std::string fault{};

  Part& part(int number) { return all.at(static_cast<std::size_t>(number) - 1); }
  bool is_right() const { return !first_part && !undecided && !fault_shows_in; }
  bool is_one_part() const { return chosen.size() == 1; }
  // " 2" where part 2 alone is checked: for commands that are named to the student.
  std::string option() const {
    return is_one_part() ? " " + std::to_string(chosen[0]->number) : "";
  }
};

// ---- building ----

// The program that runs a part's checks, as CMake calls it; and the one in which right answers
// stand for those of the earlier parts.
inline std::string target_of(const Run& run, const Part& part) {
  return part.stem + (run.sanitized ? "_sanitized_test" : "_test");
}
inline std::string given_target_of(const Part& part) { return part.stem + "_given_test"; }

// Builds every chosen part whose file compiles, with the earlier parts that it calls, and says of
// the others why not. Throws Failure if CMake itself fails.
void build_parts(Run& run);

// Builds these programs. Returns whether all could be built.
bool build_programs(const std::vector<std::string>& targets);

// The compiler's warnings about the student's own files, one a line, sorted by file and line. Those
// about files that haven't changed are kept from earlier builds.
std::vector<std::string> warnings();

// A line for each file in src/ and include/: a digest of what it holds, and its name.
std::string state_of_sources();

// What `find` gives, which is remembered under the name until a source changes.
std::string once_after_a_change(const std::string& name, const std::function<std::string()>& find);

// ---- running ----

// Of one part or of all (0), from tests/checks.txt. Throws Failure.
Run read_run(int part, bool sanitized);

// Runs the chosen parts that are built, adds up the points, and finds the first thing to do. A part
// that loses points and calls wrong earlier ones is run again with recorded right answers in place
// of theirs; the better result counts, as in the course's grading.
void run_parts(Run& run);

// Runs the part's checks in build/TARGET. One that crashes or hangs costs itself alone: the program
// is started again for the others. Throws Failure.
Result run_checks(const Run& run, const Part& part, const std::string& target);

// What the answers to all public cases tell of the mistake behind a failed check.
struct Mistake {
  std::string hint;  // its heading, "1.1 The height of the lowest corner"
  std::string
      text;  // a paragraph a line; empty if they tell nothing, or the program crashes or hangs
};
Mistake mistake_of(const Run& run, const Part& part, const Check& check);

}  // namespace bounce::check
