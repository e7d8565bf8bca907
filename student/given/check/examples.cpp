#include <algorithm>
#include <filesystem>
#include <iostream>

#include "../examples/judge.hpp"
#include "files.hpp"
#include "process.hpp"
#include "report.hpp"

namespace bounce::check {
namespace {

using Names = std::vector<std::string>;

const std::filesystem::path kPrograms = "fixtures/public/wrong_programs.txt";

// Those of a part, or of all (0).
Names of_part(const Names& names, int part) {
  Names chosen;
  for (const std::string& name : names) {
    if (!part || name[0] == '0' + part) chosen.push_back(name);
  }
  return chosen;
}

std::string listed(const Names& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

void print(const examples::Verdict& verdict) {
  std::cout << "  " << verdict.place;
  if (verdict.part) std::cout << ", part " << verdict.part << (verdict.is_right ? "" : ": wrong");
  if (!verdict.is_right) {
    std::cout << ": " << verdict.sentence << "\n";
    return;
  }
  const bool catches = !verdict.caught.empty();
  std::cout << ": right; it catches " << (catches ? listed(verdict.caught) : "no buggy program")
            << "\n";
}

// Whether nothing is left to do.
bool print_all(const examples::Judged& judged, int only) {
  bool is_done = true;
  for (const examples::Verdict& verdict : judged.verdicts) {
    if (only && verdict.part && verdict.part != only) continue;
    print(verdict);
    is_done = is_done && verdict.is_right;
  }
  for (int part = 1; part <= 3; ++part) {
    if (only && part != only) continue;
    const Names caught = of_part(judged.caught, part), missed = of_part(judged.missed, part);
    std::cout << "Part " << part << ": your cases catch " << caught.size() << " of "
              << caught.size() + missed.size() << " buggy programs."
              << (missed.empty() ? "" : " Not caught yet: " + listed(missed) + ".") << "\n";
    is_done = is_done && missed.empty();
  }
  if (!of_part(judged.missed, only).empty()) {
    std::cout << "A hint for the first of these: ./check "
              << (only ? std::to_string(only) + " " : "") << "--examples --hint\n";
  }
  return is_done;
}

// The next stage for the first buggy program that is left.
void print_hint(const Names& missed) {
  if (missed.empty()) {
    std::cout << "Your cases catch all buggy programs: no hint is needed.\n";
    return;
  }
  const std::string& program = missed.front();
  const int stage = std::min(next_stage(program), kStages);
  const Names lines = lines_of(read("given/examples/hints.txt"));
  const auto name = std::find(lines.begin(), lines.end(), program);
  std::cout << "Buggy program " << program << ", hint " << stage << " of " << kStages << ": "
            << name[stage] << "\n";
}

}  // namespace

bool judge_examples(int part, bool hints) {
  std::filesystem::create_directories(kWork);
  for (const std::filesystem::path& file : {std::filesystem::path("examples.txt"), kPrograms}) {
    if (!std::filesystem::exists(file)) {
      throw Failure(file.generic_string() + " is missing: copy it from the handout's zip");
    }
  }
  const examples::Table table(read(kPrograms));
  if (part && !table.right.count(part)) {
    throw Failure("cases are for parts 1 to 3: part " + std::to_string(part) +
                  " only repeats the step of part 3");
  }
  const examples::Judged judged = examples::judge(read("examples.txt"), table);
  if (!hints) return print_all(judged, part);
  print_hint(of_part(judged.missed, part));
  return false;
}

}  // namespace bounce::check
