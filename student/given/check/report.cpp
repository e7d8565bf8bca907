#include "report.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <iostream>

#include "files.hpp"
#include "process.hpp"
#include "words.hpp"

namespace bounce::check {
namespace {

constexpr std::size_t kMostPrinted = 10, kMostWarnings = 3;  // lines
constexpr const char *kRed = "\033[31m", *kGreen = "\033[32m";

std::string coloured(const std::string& text, const char* begin) {
  const auto is_set = [](const char* name) { return std::getenv(name) && *std::getenv(name); };
  static const bool has_colours = is_terminal() && !is_set("NO_COLOR") &&
                                  !(is_set("TERM") && std::getenv("TERM") == std::string("dumb"));
  return has_colours ? begin + text + "\033[0m" : text;
}

std::string bold(const std::string& text) { return coloured(text, "\033[1m"); }

std::string in_columns(const std::string& text, int width, int points, int of) {
  char line[200];
  std::snprintf(line, sizeof line, "%-*s%4d / %d", width, text.c_str(), points, of);
  return line;
}

void print_checks(const Part& part) {
  bool is_one_unknown = false;
  for (const Check& check : part.checks) {
    const std::string status = part.result.note(check).status;
    const bool passed = status == "passed", unknown = status == "unknown" || status == kUndecided;
    is_one_unknown = is_one_unknown || unknown;
    const std::string row =
        " " + in_columns(check.title, 57, passed ? check.points : 0, check.points);
    std::cout << "  "
              << (passed    ? coloured("\u2713" + row, kGreen)
                  : unknown ? dim("?" + row)
                            : coloured("\u2717" + row, kRed))
              << "\n";
  }
  if (is_one_unknown)
    std::cout << dim(
        "  ? = undecided: two checks before it gave no answer, or it needs correct earlier "
        "parts\n");
}

void print_part(const Run& run, const Part& part) {
  const Part* broken = part.broken;
  const bool is_needed = broken && broken != &part;
  std::string what = part.title;
  if (broken) {
    what = is_needed ? "not run: it needs part " + std::to_string(broken->number) + ", which " : "";
    what += broken->error.is_of_linker ? "compiles, but does not link" : "does not compile";
  }
  what = in_columns("Part " + std::to_string(part.number) + "  " + what, 61, part.worth(),
                    part.points);
  std::cout << (is_needed ? dim(what) : bold(what)) << "\n";
  if (part.is_given) std::cout << dim("        with correct earlier parts in place of yours\n");
  if (part.undecided() > 0) {
    std::cout << dim("        " + std::to_string(part.undecided()) +
                     " more points are undecided until the earlier parts are correct\n");
  }
  const bool is_open = part.undecided() > 0 && run.is_one_part();
  if ((&part == run.first_part && run.first_check) || is_open) print_checks(part);
}

std::string mark_of(const std::string& status) {
  if (status == "passed") return "\u2713";
  if (status == "unknown") return "\u00b7";
  return status == kUndecided ? "?" : "\u2717";
}

// All checks in the order in which they are won, a mark each, and how many pass; those of the last
// run are remembered.
void print_ladder(const Run& run) {
  const auto file = kWork / "ladder";
  std::string ladder;
  int passed = 0, all = 0;
  for (const Part& part : run.all) {
    for (const Check& check : part.checks) {
      const std::string status = part.result.note(check).status;
      const bool is_next = &part == run.first_part &&
                           &check == (run.first_check ? run.first_check : &part.checks.front());
      ladder += is_next ? "\u2192" : mark_of(status);
      passed += status == "passed";
      ++all;
    }
    ladder += "  ";
  }
  const int more = passed - std::atoi(read(file).c_str());
  std::cout << "Checks  " << ladder << bold(std::to_string(passed) + " of " + std::to_string(all))
            << " checks pass"
            << (more != 0 && std::filesystem::exists(file)
                    ? ", " + std::to_string(std::abs(more)) + (more > 0 ? " more" : " fewer") +
                          " than last time"
                    : "")
            << (run.first_part ? "; \u2192 is next" : "") << "\n";
  write(file, std::to_string(passed));
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
  const std::string file = part.result.prints;
  if (!note.to || own_prints(part, read(file)).empty()) return;
  const auto lines = own_prints(part, read(file, note.from, *note.to));
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
    if (file_of(line) != part.file() || !has(line, "[-Wreturn-type]")) continue;
    std::cout
        << "  " << file_of(line) << ":" << line_of(line)
        << ": the function can end without returning a value; its result is then arbitrary.\n";
  }
}

void print_text(const std::string& text) {
  for (const std::string& line : lines_of(text)) {
    if (!line.empty()) std::cout << "  " << line << "\n";
  }
}

void print_fault_of_earlier(const Run& run) {
  const std::string number = std::to_string(run.fault_shows_in->number);
  std::cout << heading("Part " + number +
                       " scores higher with correct earlier parts in place of yours.")
            << "\nSo either one of your earlier parts is wrong in a case that its own checks don't "
               "cover,\nor part "
            << number << " keeps something from one call to the next. With your earlier parts:\n";
  print_text(run.fault);
}

void print_first(const Run& run) {
  const Part& part = *run.first_part;
  if (!run.first_check) {
    print_what_does_not_compile(run);
    return;
  }
  std::cout << heading("First: " + run.first_check->title) << "  " << dim("(" + part.file() + ")")
            << "\n";
  const Note note = part.result.note(*run.first_check);
  print_text(note.text);
  print_missing_returns(part);
  if (run.sanitized && note.status == "crashed") return;  // what was found says more than the rest
  print_what_was_printed(part, note);
  const Mistake mistake = mistake_of(run, part, *run.first_check);
  if (!mistake.text.empty()) std::cout << "\n" << folded(mistake.text, 74, "  ") << "\n";
  std::cout << "  Hint " << mistake.hint << ": ./check" << run.option()
            << " --hint opens it, stage by stage.\n";
}

void print_warnings(const Run& run) {
  std::string broken;  // files in which the compiler may not have reached what seems unused
  for (const Part& part : run.all) {
    if (part.broken == &part) broken += part.file() + "\n";
  }
  std::vector<std::string> all;
  for (const std::string& line : warnings()) {
    if (!has(line, "warning: unused ") || !has(broken, file_of(line) + "\n")) all.push_back(line);
  }
  if (all.empty()) return;
  std::cout << bold("The compiler warns") << " of what is often a mistake:\n";
  for (std::size_t i = 0; i < all.size() && i < kMostWarnings; ++i) {
    const std::string text = all[i].substr(0, 200);
    const std::size_t mark = text.find(" warning: ") + 10;
    std::cout << "  " << file_of(text) << ":" << line_of(text) << ": "
              << text.substr(mark, text.rfind(" [-W") - mark) << "\n";
  }
  if (all.size() > kMostWarnings) {
    std::cout << "  and " << all.size() - kMostWarnings << " more, in "
              << (kWork / "warnings").generic_string() << "\n";
  }
}

// What sanitizers find, in a sentence; empty if nothing. Throws Failure where they can't be used.
std::string undefined_behaviour() {
  if (!kHasSanitizers) throw Failure("on Windows there are no sanitizers for it");
  std::cout << dim("Looking for undefined behaviour, with sanitizers: some seconds, once after a "
                   "change.")
            << std::endl;
  Run run = read_run(0, true);
  build_parts(run);
  for (const Part& part : run.all) {
    if (part.broken) throw Failure("the sanitizers of this compiler can't be used here");
  }
  run_parts(run);
  for (const Part& part : run.all) {
    const auto found = found_by_sanitizers(read(part.result.prints));
    if (!found.empty()) return found;
  }
  // A check that is too slow with them tells nothing.
  for (const Part& part : run.all) {
    for (const Check& check : part.checks) {
      const std::string status = part.result.note(check).status;
      if (status == "failed" || status == "crashed")
        return part.file() + ": built with the sanitizers, the program fails \"" + check.title +
               "\": does it use a value that was never set, or one that no longer exists?";
    }
  }
  return "";
}

// Prints what sanitizers find in a program that passes all checks.
bool has_defined_behaviour() try {
  const std::string found = once_after_a_change("undefined", undefined_behaviour);
  if (found.empty()) return true;
  std::cout << heading("First: undefined behaviour") << "\n"
            << folded(printable(found) + (found.back() == '?' ? "" : "."), 74, "  ")
            << folded(
                   "The numbers are correct here and now, but may differ on another machine or "
                   "when the program is optimised. Fix this before you submit.",
                   74, "  ");
  return false;
} catch (const Failure& not_asked) {
  std::cout << "Undefined behaviour was not looked for: " << not_asked.what() << ".\n";
  return true;
}

}  // namespace

void print_what_does_not_compile(const Run& run) {
  const Part& part = *run.first_part;
  const Part& broken = part.broken ? *part.broken : part;
  std::cout << heading("First: make " + broken.stem + ".cpp " +
                       (broken.error.is_of_linker ? "link" : "compile"))
            << "\n"
            << broken.error.text << "\n";
}

bool report(const Run& run) {
  for (const Part* part : run.chosen) print_part(run, *part);
  if (!run.is_one_part()) print_ladder(run);
  const Part& last = *run.chosen.back();
  if (run.first_part && !run.is_one_part() && run.first_part != &last) {
    std::cout << dim("Parts 3 and 4 call earlier ones, so part " +
                     std::to_string(run.first_part->number) + " comes first.\n");
  } else if ((run.first_part || run.undecided > 0) && run.is_one_part() && !last.calls.empty()) {
    std::cout << dim("Part" + run.option() +
                     " calls earlier parts; if ./check finds one of them wrong, fix that one "
                     "first.\n");
  }
  if (run.first_part) print_first(run);
  if (run.fault_shows_in) print_fault_of_earlier(run);
  std::cout << heading("Score on the public checks" +
                       (run.is_one_part() ? " of part" + run.option() : "") + ": " +
                       std::to_string(run.score) + " / " + std::to_string(run.possible) + ".")
            << " There are also hidden ones, with different numbers.\n";
  print_warnings(run);
  return run.is_right() && (run.is_one_part() || run.sanitized || has_defined_behaviour());
}

std::string heading(const std::string& text) { return "\n" + bold(text); }
std::string dim(const std::string& text) { return coloured(text, "\033[2m"); }

}  // namespace bounce::check
