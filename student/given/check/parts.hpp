// The parts and their checks, as tests/checks.txt says; and what this run knows of them.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

namespace bounce::check {

struct Check {
  std::string id, title;
  int points = 0;
};

struct Part {
  int number = 0;
  std::string stem, title;
  int points = 0;
  std::vector<int> calls;  // earlier parts
  std::vector<Check> checks;
  std::string notes = "notes";  // the folder, in build/check, of what is known of them

  std::string file() const { return "src/" + stem + ".cpp"; }
};

// From tests/checks.txt. Throws Failure.
std::vector<Part> read_parts();

// What one run of the checks is about, and what came out.
struct Run {
  std::vector<Part> all;
  std::vector<int> chosen;             // numbers of the parts to check
  std::map<int, int> unbuilt;          // part that wasn't built -> part whose file has the error
  std::map<int, std::string> errors;   // the first error in a part's file, indented, with its line
  std::set<int> unlinked;              // those that compile, but don't link with the earlier ones
  std::set<int> given;                 // parts whose better result is that with right earlier parts
  bool sanitized = false;              // whether the parts are built with sanitizers
  int score = 0, possible = 0;         // of the chosen parts
  int undecided = 0;                   // points of checks that wait for right earlier parts
  const Part* first_part = nullptr;    // where the first thing to do is, if there is one
  const Check* first_check = nullptr;  // null where that part isn't built
  // A part that scores better with right earlier parts than with the student's, though these pass
  // their own checks; and what its first check that fails says with the student's.
  const Part* fault_shows_in = nullptr;
  std::string fault;

  const Part& part(int number) const { return all.at(static_cast<std::size_t>(number) - 1); }
  // The program that runs a part's checks, as CMake calls it; it is in the folder build.
  std::string target(const Part& part) const {
    return part.stem + (sanitized ? "_sanitized_test" : "_test");
  }
  // The one in which right answers stand for those of the earlier parts.
  std::string given_target(const Part& part) const { return part.stem + "_given_test"; }
  bool is_right() const { return !first_part && !undecided && !fault_shows_in; }
  bool is_one_part() const { return chosen.size() == 1; }
  // " 2" where part 2 alone is checked: for commands that are named to the student.
  std::string option() const { return is_one_part() ? " " + std::to_string(chosen[0]) : ""; }
};

}  // namespace bounce::check
