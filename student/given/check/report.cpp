#include "report.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <iostream>

#include "build.hpp"
#include "compiler_words.hpp"
#include "files.hpp"
#include "process.hpp"
#include "run.hpp"

namespace bounce::check {
namespace {

constexpr std::size_t kMostPrinted = 10, kMostWarnings = 3;  // lines

std::string in_columns(const std::string& text, int width, int points, int of) {
  char line[200];
  std::snprintf(line, sizeof line, "%-*s%4d / %d", width, text.c_str(), points, of);
  return line;
}

void print_checks(const Part& part) {
  bool is_one_unknown = false;
  for (const Check& check : part.checks) {
    const std::string status = note_of(part, check).status;
    const bool passed = status == "passed";
    const bool unknown = status == "unknown" || status == kUndecided;
    is_one_unknown = is_one_unknown || unknown;
    std::cout << "  "
              << (passed    ? style().green + "\u2713"
                  : unknown ? style().dim + "?"
                            : style().red + "\u2717")
              << " " << in_columns(check.title, 57, passed ? check.points : 0, check.points)
              << style().plain << "\n";
  }
  if (!is_one_unknown) return;
  std::cout << style().dim
            << "  ? is open: two before it gave no answer, or it waits for right earlier "
            << "parts" << style().plain << "\n";
}

void print_part(const Run& run, const Part& part) {
  const auto unbuilt = run.unbuilt.find(part.number);
  const int points = unbuilt == run.unbuilt.end() ? points_of(part) : 0;
  const bool is_needed = unbuilt != run.unbuilt.end() && unbuilt->second != part.number;
  std::string what = part.title;
  if (unbuilt != run.unbuilt.end()) {
    const bool links = !run.unlinked.count(unbuilt->second);
    what = (is_needed ? "not run: it needs part " + std::to_string(unbuilt->second) + ", which "
                      : "") +
           (links ? "does not compile" : "compiles, but does not link");
  }
  const std::string heading = "Part " + std::to_string(part.number) + "  " + what;
  std::cout << (is_needed ? style().dim : style().bold)
            << in_columns(heading, 61, points, part.points) << style().plain << "\n";
  if (run.given.count(part.number)) {
    std::cout << style().dim << "        with right earlier parts in place of yours"
              << style().plain << "\n";
  }
  const int undecided = undecided_of(run, part);
  if (undecided > 0) {
    std::cout << style().dim << "        " << undecided
              << " more can be decided once the earlier parts are right" << style().plain << "\n";
  }
  const bool is_open = undecided > 0 && run.is_one_part();
  if ((&part == run.first_part && run.first_check) || is_open) print_checks(part);
}

// The lines, without what assertions and exceptions print behind what the part has printed.
std::vector<std::string> own_prints(const Part& part, const std::string& printed) {
  std::vector<std::string> own;
  for (std::string line : lines_of(printed)) {
    const bool is_empty = line.empty();
    for (const std::string& mark :
         {part.stem + "_", std::string("/usr/include/"), std::string("Assertion failed: "),
          std::string("terminate called "), std::string("  what(): ")}) {
      line.erase(std::min(line.find(mark), line.size()));
    }
    if (is_empty || !line.empty()) own.push_back(line);
  }
  return own;
}

// Those of the case that is told of, and not of those before and after it.
void print_what_was_printed(const Part& part, const Note& note) {
  const std::string file = prints_file(part.number);
  if (!note.has_prints || own_prints(part, read(file)).empty()) return;
  const auto lines = own_prints(part, read(file, note.from, note.to));
  if (lines.empty()) {
    std::cout << "  Your program printed nothing in this case; all that it printed is in " << file
              << ".\n";
    return;
  }
  std::cout << "  Your program printed in this case (all that it printed is in " << file << "):\n";
  for (std::size_t i = 0; i < lines.size() && i < kMostPrinted; ++i) {
    std::cout << "    " << printable(lines[i].substr(0, 100)) << "\n";
  }
  if (lines.size() > kMostPrinted) std::cout << "    ...\n";
}

// Where a return is missing, numbers are wrong, or the program crashes, for no other reason.
void print_missing_returns(const Part& part) {
  for (const std::string& line : warnings()) {
    if (file_of(line) != part.file() || !is_missing_return(line)) continue;
    std::cout << "  " << file_of(line) << ":" << line_of(line)
              << ": the function can end without return, and what it gives is then anything.\n";
  }
}

void print_text(const std::string& text) {
  for (const std::string& line : lines_of(text)) {
    if (!line.empty()) std::cout << "  " << line << "\n";
  }
}

void print_fault_of_earlier(const Run& run) {
  std::cout << "\n"
            << style().bold << "Part " << run.fault_shows_in->number
            << " does better with right earlier parts in place of yours." << style().plain
            << "\nSo one of yours is wrong in a case that its own checks don't ask, unless part "
            << run.fault_shows_in->number
            << " keeps\nsomething from one call to the next. With yours:\n";
  print_text(run.fault);
}

void print_first(const Run& run) {
  const Part& part = *run.first_part;
  if (!run.first_check) {
    print_what_does_not_compile(run);
    return;
  }
  std::cout << "\n"
            << style().bold << "First: " << run.first_check->title << style().plain << "  "
            << style().dim << "(" << part.file() << ")" << style().plain << "\n";
  const Note note = note_of(part, *run.first_check);
  print_text(note.text);
  print_missing_returns(part);
  if (run.sanitized && note.status == "crashed") return;  // what was found says more than the rest
  print_what_was_printed(part, note);
  const std::string mistake = mistake_of(run, part);
  if (!mistake.empty()) std::cout << "\n" << folded(mistake, 74, "  ") << "\n";
  std::cout << "  Hint " << heading_of(part, *run.first_check, mistake) << ": ./check"
            << run.option() << " --hint opens it, stage by stage.\n";
}

void print_warnings() {
  const std::vector<std::string> all = warnings();
  if (all.empty()) return;
  std::cout << style().bold << "The compiler warns" << style().plain
            << " of what is often a mistake:\n";
  for (std::size_t i = 0; i < all.size() && i < kMostWarnings; ++i) {
    const std::string text = all[i].substr(0, 200);
    const std::size_t mark = text.find(" warning: ");
    const std::size_t flag = text.rfind(" [-W");
    std::cout << "  " << file_of(text) << ":" << line_of(text) << ": "
              << text.substr(mark + 10, flag == std::string::npos ? flag : flag - mark - 10)
              << "\n";
  }
  if (all.size() > kMostWarnings) {
    std::cout << "  and " << all.size() - kMostWarnings << " more, in "
              << (kWork / "warnings").generic_string() << "\n";
  }
}

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

// What sanitizers find, in a sentence; empty if nothing. Throws Failure where they can't be used.
std::string undefined_behaviour() {
  if (!kHasSanitizers) throw Failure("on Windows there are no sanitizers for it");
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

// Prints what sanitizers find in a program that passes all checks.
bool has_defined_behaviour() try {
  const std::string found = once_after_a_change("undefined", true, undefined_behaviour);
  if (found.empty()) return true;
  std::cout << "\n"
            << style().bold << "First: undefined behaviour" << style().plain << "\n"
            << folded(printable(found) + (found.back() == '?' ? "" : "."), 74, "  ")
            << folded(
                   "The numbers are right here and now, and may be others on another machine or "
                   "when the program is optimised. Fix this before you submit.",
                   74, "  ");
  return false;
} catch (const Failure& not_asked) {
  std::cout << "Undefined behaviour was not looked for: " << not_asked.what() << ".\n";
  return true;
}

}  // namespace

void print_what_does_not_compile(const Run& run) {
  const auto unbuilt = run.unbuilt.find(run.first_part->number);
  const int broken = unbuilt == run.unbuilt.end() ? run.first_part->number : unbuilt->second;
  std::cout << "\n"
            << style().bold << "First: make " << run.part(broken).stem << ".cpp "
            << (run.unlinked.count(broken) ? "link" : "compile") << style().plain << "\n"
            << run.errors.at(broken) << "\n";
}

bool report(const Run& run) {
  for (const int number : run.chosen) print_part(run, run.part(number));
  const bool calls = !run.part(run.chosen.back()).calls.empty();
  if (run.first_part && !run.is_one_part() && run.first_part != &run.part(run.chosen.back())) {
    std::cout << style().dim << "Parts 3 and 4 call earlier ones, so part "
              << run.first_part->number << " comes first." << style().plain << "\n";
  } else if ((run.first_part || run.undecided > 0) && run.is_one_part() && calls) {
    std::cout << style().dim << "Part " << run.chosen[0]
              << " calls earlier ones; where ./check finds one of them wrong, fix that first."
              << style().plain << "\n";
  }
  if (run.first_part) print_first(run);
  if (run.fault_shows_in) print_fault_of_earlier(run);
  std::cout << "\n"
            << style().bold << "Score on the public checks"
            << (run.is_one_part() ? " of part" + run.option() : "") << ": " << run.score << " / "
            << run.possible << "." << style().plain
            << " There are hidden ones as well, with other numbers.\n";
  print_warnings();
  return run.is_right() && (run.is_one_part() || run.sanitized || has_defined_behaviour());
}

const Style& style() {
  const auto is_set = [](const char* name, const std::string& to) {
    const char* value = std::getenv(name);
    return value && (to.empty() ? *value : value == to);
  };
  static const Style plain{}, coloured{"\033[1m", "\033[31m", "\033[32m", "\033[2m", "\033[0m"};
  static const bool has_colours =
      is_terminal() && !is_set("TERM", "dumb") && !is_set("NO_COLOR", "");
  return has_colours ? coloured : plain;
}

}  // namespace bounce::check
