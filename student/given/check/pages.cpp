#include <ctime>
#include <filesystem>
#include <iostream>

#include "files.hpp"
#include "process.hpp"
#include "report.hpp"
#include "words.hpp"

namespace bounce::check {
namespace {

namespace fs = std::filesystem;

// Of a program that gives other numbers when it is optimised, a page would tell what is not so.
void require_same_when_optimised(const Run& run) {
  Part all;
  for (const Part* part : run.chosen) {
    for (const Check& check : part->checks) {
      if (!part->is_given && part->result.note(check).status == "passed")
        all.checks.push_back(check);
    }
  }
  all.result = run_checks(run, all, "optimised_test");
  for (const Check& check : all.checks) {
    const std::string status = all.result.note(check).status;
    if (status == "passed") continue;
    throw Failure("no study was written: your program gives " +
                  std::string(status == "failed" ? "different" : "no") +
                  " numbers when it is optimised; the usual cause is `auto` for a matrix");
  }
}

// Starts build/NAME, which writes NAME.html from its table. Returns what it printed.
std::string write_page(const std::string& name, bool is_wrong, const std::string& table) {
  const fs::path said = kWork / (name + ".txt");
  fs::remove(said);
  std::vector<std::string> command{"build/" + name, table, name + ".html"};
  if (is_wrong) command.emplace_back("--wrong");
  const auto ended = check::run(command, said, Limits::of_a_part);
  const std::string printed = read(said);
  if (!ended) throw Failure(command[0] + " can't be started: remove the folder build");
  if (*ended == 1) throw Failure(printed);
  if (*ended) throw Failure("no page was written, as " + reason_of(*ended, printed));
  return printed;
}

std::string measured(const Run& run) {
  std::cout << dim("Measuring what your program is worth: this takes a minute or less.")
            << std::endl;
  fs::remove("study.html");  // one of another program
  if (!build_programs({"study", "optimised_test"})) {
    throw Failure("the study needs all four parts to compile");
  }
  require_same_when_optimised(run);
  return write_page("study", run.first_part, "fixtures/study.json");
}

// "29 November at 14:05"
std::string this_minute() {
  const std::time_t now = std::time(nullptr);
  char text[60];
  std::strftime(text, sizeof text, "%d %B at %H:%M", std::localtime(&now));
  return text;
}

}  // namespace

void study(const Run& run, bool is_asked) {
  const fs::path last = kWork / "verdict_found.txt";  // when it was, and of what
  const std::string when = read(last), sources = state_of_sources();
  if (!is_asked && !when.empty() && fs::exists("study.html")) {
    const std::string at = when.substr(0, when.find('\n'));
    const bool is_of_these = when.substr(at.size() + 1) == sources;
    std::cout << heading("What your program is worth") << " is in study.html, measured on " << at
              << (is_of_these ? "" : ", before your last change") << ".\n./check --study measures "
              << "it again.\n";
    return;
  }
  const std::string verdict = measured(run);
  write(last, this_minute() + "\n" + sources);
  std::cout << heading("What your program is worth")
            << ", with charts in study.html and questions in explore.html:\n";
  for (const std::string& line : lines_of(verdict)) {
    const std::size_t tab = line.find('\t');
    std::string text = folded(line.substr(tab + 1), 66, std::string(14, ' '));
    std::cout << text.replace(2, tab, line.substr(0, tab));
  }
  std::cout << "Both speed and accuracy count: chart one against the other, test stability where\n"
               "methods fail, and model no more than a scene needs.\n";
}

void ask_about_real_impacts(Run& run) {
  const Part& part = run.part(2);
  fs::remove("real.html");  // one of another program
  if (part.broken || !build_programs({"real"})) throw Failure("--real needs part 2 to compile");
  const std::string said = write_page("real", part.worth() < part.points, "fixtures/measured.json");
  std::cout << "\n"
            << folded(said, 78, "") << "Each of them is in real.html; open it in a browser.\n";
}

}  // namespace bounce::check
