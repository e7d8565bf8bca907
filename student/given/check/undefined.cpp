#include "undefined.hpp"

#include <iostream>

#include "build.hpp"
#include "compiler_words.hpp"
#include "files.hpp"
#include "run.hpp"
#include "style.hpp"

namespace bounce::check {
namespace {

// The first check that fails where all pass without sanitizers. One that is too slow with them, or
// takes too much memory, tells nothing.
std::string other_numbers(const Part& part) {
  for (const Check& check : part.checks) {
    if (note_of(part, check).status != "failed") continue;
    return part.file() + ": built with the sanitizers, the program fails \"" + check.title +
           "\": does it use a value that was never set, or that is gone?";
  }
  return "";
}

std::string look() {
  std::cout << style().dim
            << "Looking for undefined behaviour, with sanitizers: some seconds, once "
            << "after a change." << style().plain << std::endl;
  Run run;
  run.all = read_parts();
  run.sanitized = true;
  for (Part& part : run.all) {
    part.notes = "sanitized_notes";
    run.chosen.push_back(part.number);
  }
  build_parts(run);
  if (!run.unbuilt.empty()) throw Failure("the sanitizers of this compiler can't be used here");
  run_parts(run);
  for (const Part& part : run.all) {
    const auto found = found_by_sanitizers(own_lines(read(prints_file(part.number))));
    if (!found.empty()) return found;
  }
  for (const Part& part : run.all) {
    if (const auto found = other_numbers(part); !found.empty()) return found;
  }
  return "";
}

}  // namespace

std::string undefined_behaviour() {
  if (!kHasSanitizers) throw Failure("on Windows there are no sanitizers for it");
  return once_after_a_change("undefined", true, look);
}

}  // namespace bounce::check
