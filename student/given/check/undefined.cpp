#include "undefined.hpp"

#include <filesystem>
#include <iostream>

#include "build.hpp"
#include "compiler_words.hpp"
#include "files.hpp"
#include "run.hpp"
#include "style.hpp"

namespace bounce::check {
namespace {

namespace fs = std::filesystem;

// The notes of the checks stay those of the program as it is built for the checks.
class Aside {
 public:
  Aside() {
    fs::remove_all(aside_);
    fs::rename(notes_, aside_);
  }
  ~Aside() {
    std::error_code gone;
    fs::remove_all(notes_, gone);
    fs::rename(aside_, notes_, gone);
  }
  Aside(const Aside&) = delete;
  Aside& operator=(const Aside&) = delete;

 private:
  fs::path notes_ = kWork / "notes", aside_ = kWork / "notes_aside";
};

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

Undefined look() {
  Run run;
  run.all = read_parts();
  run.sanitized = true;
  for (const Part& part : run.all) run.chosen.push_back(part.number);
  build_parts(run);
  if (!run.unbuilt.empty()) return {"", "the sanitizers of this compiler can't be used here"};
  const Aside aside;
  run_parts(run);
  for (const Part& part : run.all) {
    const auto found = found_by_sanitizers(own_lines(read(prints_file(part.number))));
    if (!found.empty()) return {found, ""};
  }
  for (const Part& part : run.all) {
    if (const auto found = other_numbers(part); !found.empty()) return {found, ""};
  }
  return {};
}

}  // namespace

Undefined undefined_behaviour() {
  if (!kHasSanitizers) return {"", "on Windows there are no sanitizers for it"};
  const fs::path file = kWork / "undefined.txt";
  const std::string now = state_of_sources(), before = read(file);
  const std::size_t end = before.find("\n\n");
  if (end != std::string::npos && before.substr(0, end + 1) == now) {
    return {before.substr(end + 2), ""};
  }
  std::cout << style().dim
            << "Looking for undefined behaviour, with sanitizers: some seconds, once "
            << "after a change." << style().plain << std::endl;
  const Undefined undefined = look();
  if (undefined.not_asked.empty()) write(file, now + "\n" + undefined.found);
  return undefined;
}

}  // namespace bounce::check
