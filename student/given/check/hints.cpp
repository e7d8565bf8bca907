#include <algorithm>
#include <iostream>

#include "files.hpp"
#include "process.hpp"
#include "report.hpp"

namespace bounce::check {
namespace {

std::string page_of(const Part& part) { return "hints/" + part.stem + ".md"; }

// The stage's text below the heading; the last begins with the state of its worked numbers, which
// the page's third line says.
void print_stage(const std::string& page, const std::string& heading, int stage) {
  const std::vector<std::string> lines = lines_of(read(page));
  bool here = false, fenced = false;
  int n = 0;
  for (const std::string& line : lines) {
    if (begins(line, "## ")) {
      here = line == "## " + heading;
      n = 0;
    }
    if (here && begins(line, "### ")) {
      if (++n != stage) continue;
      std::cout << folded(
          "Hint " + heading + ", stage " + std::to_string(n) + " of 3: " + line.substr(4), 78, "");
      if (n == kStages)
        std::cout << "\n" << folded(lines.at(2).substr(lines.at(2).find("Unless")), 78, "");
    } else if (begins(line, "```")) {
      fenced = !fenced;
    } else if (here && n == stage) {
      std::cout << (line.empty() ? "\n" : folded((fenced ? "    " : "") + line, 78, ""));
    }
  }
}

}  // namespace

int next_stage(const std::string& name) {
  const std::filesystem::path file = kWork / "hint";
  const std::vector<std::string> last = lines_of(read(file));
  const bool same = last.size() == 2 && last[1] == name;
  const int stage = same ? std::stoi(last[0]) + 1 : 1;
  write(file, std::to_string(stage) + "\n" + name + "\n");
  return stage;
}

void hint(const Run& run) {
  if (!run.first_part) {
    std::cout << (run.is_right()
                      ? "Every public check passes: no hint is needed.\n"
                      : "Fix the earlier parts first; the remaining checks need them.\n");
    return;
  }
  if (!run.first_check) {
    print_what_does_not_compile(run);
    return;
  }
  const std::string heading = mistake_of(run, *run.first_part, *run.first_check).hint;
  const int stage = next_stage(heading);
  const std::string page = page_of(*run.first_part);
  std::cout << "For: " << run.first_check->title << "\n";
  print_stage(page, heading, std::min(stage, kStages));
  if (stage == kStages) {
    std::cout << "That was the last stage. All are in " << page << ".\n";
  } else if (stage > kStages) {
    std::cout
        << "That was the last stage again. Work its numbers out by hand, print the same ones\n"
           "in your program, and see where they part. All stages are in "
        << page << ".\n";
  }
}

}  // namespace bounce::check
