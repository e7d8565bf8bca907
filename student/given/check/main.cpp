// Builds what has changed, runs the public checks part by part, and shows the first thing to do.
// ./check and check.cmd start it; README.md says what it can do.
#include <cstdlib>
#include <filesystem>
#include <iostream>

#include "build.hpp"
#include "files.hpp"
#include "hints.hpp"
#include "parts.hpp"
#include "process.hpp"
#include "report.hpp"
#include "run.hpp"
#include "style.hpp"

namespace bounce::check {
namespace {

constexpr int kAllPass = 0, kSomethingFails = 1, kUsage = 2, kCannotCheck = 3;
constexpr const char* kKnown =
    "./check            all four parts\n"
    "./check 2          part 2 alone\n"
    "./check --examples which wrong programs the cases in examples.txt catch; with --hint, a hint\n"
    "./check --hint     the next stage of the hint for the first check that fails; or ./check 2 "
    "--hint\n"
    "./check --sanitize finds wrong uses of memory, too; slower\n"
    "./check --real     what your part 2 makes of measured impacts, as a page\n"
    "./check --study    how accurate, fast and stable your program is, as a page\n"
    "./check --watch    again whenever you save a file; h is the next hint, 1 to 4 a part, a all, "
    "q the end\n";

struct Options {
  int part = 0;  // 0: all
  bool hints = false, watches = false, sanitized = false, studies = false, real = false,
       examples = false;
};

struct Usage : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// "2", or the name of its file as an editor gives it: "part2_lcp".
std::string number_of(const std::string& word, const std::vector<Part>& parts) {
  for (const Part& part : parts) {
    if (word == part.stem) return std::to_string(part.number);
  }
  return word;
}

Options read_options(const std::vector<std::string>& words, const std::vector<Part>& parts) {
  Options options;
  for (const std::string& given : words) {
    const std::string word = number_of(given, parts);
    const bool is_number = word.size() == 1 && word[0] >= '1' && word[0] < char('1' + parts.size());
    if (is_number && options.part) {
      throw Failure("one part at a time, or all: ./check " + word + ", or ./check");
    }
    if (is_number) {
      options.part = word[0] - '0';
    } else if (word == "--examples") {
      options.examples = true;
    } else if (word == "--hint") {
      options.hints = true;
    } else if (word == "--sanitize" && !kHasSanitizers) {
      throw Failure("--sanitize needs g++ or clang on Linux or macOS");
    } else if (word == "--sanitize") {
      options.sanitized = true;
    } else if (word == "--real") {
      options.real = true;
    } else if (word == "--study") {
      options.studies = true;
    } else if (word == "--watch") {
      options.watches = true;
    } else {
      throw Usage("check: " + word + " is not known; there are:\n" + kKnown);
    }
  }
  if (options.real && options.part && options.part != 2) {
    throw Failure("--real asks part 2: ./check 2 --real, or ./check --real");
  }
  return options;
}

Run run_of(const Options& options) {
  Run run;
  run.all = read_parts();
  run.sanitized = options.sanitized;
  for (const Part& part : run.all) {
    if (!options.part || options.part == part.number) run.chosen.push_back(part.number);
  }
  return run;
}

// Whether there is nothing to mend. The screen is cleared before the result, where that `replaces`
// another.
bool check(const Options& options, bool replaces = false) {
  std::filesystem::create_directories(kWork);
  const Lock alone(kWork / "lock");
  Run run = run_of(options);
  build_parts(run);
  run_parts(run);
  if (replaces && is_terminal()) std::cout << "\033[H\033[2J";
  bool is_right = !run.first_part;
  if (options.hints) {
    hint(run);
  } else {
    is_right = report(run);
  }
  if (options.studies) study(run);
  if (options.real) ask_about_real_impacts(run);
  std::cout << std::flush;
  return is_right;
}

// Until a file changes, or a key asks for something. False: it asks for the end.
bool wait(Keys& keys, Options& options, const std::string& before) {
  std::cout << style().dim << "Waiting for a change in src/. Keys: h the next hint, 1 to 4 a part, "
            << "a all, r again, q the end." << style().plain << std::endl;
  options.hints = false;
  while (state_of_sources() == before) {
    switch (const char key = keys.next()) {
      case 0:
        break;
      case 'q':
        return false;
      case 'h':
        options.hints = true;
        return true;
      case 'a':
        options.part = 0;
        return true;
      case 'r':
        return true;
      default:
        if (key >= '1' && key <= '4') {
          options.part = key - '0';
          return true;
        }
    }
  }
  return true;
}

void watch(Options options) {
  Keys keys;
  std::string before;
  for (bool again = false;; again = true) {
    before = state_of_sources();
    if (again) {
      std::cout << style().dim << "Checking again; the result above is the last one."
                << style().plain << std::endl;
    }
    try {
      check(options, again && !options.hints);
    } catch (const Failure& failure) {  // a file may be missing for a moment
      std::cout << "check: " << failure.what() << "\n";
    }
    if (!wait(keys, options, before)) return;
  }
}

int run(const std::vector<std::string>& words) {
  if (words.size() == 1 && (words[0] == "-h" || words[0] == "--help")) {
    std::cout << kKnown;
    return kAllPass;
  }
  const Options options = read_options(words, read_parts());
  if (options.examples) {
    return judge_examples(options.part, options.hints) ? kAllPass : kSomethingFails;
  }
  if (options.watches) {
    watch(options);
    return kAllPass;
  }
  return check(options) ? kAllPass : kSomethingFails;
}

}  // namespace
}  // namespace bounce::check

int main(int argc, char** argv) {
  using namespace bounce::check;
  try {
    return run({argv + 1, argv + argc});
  } catch (const Usage& usage) {
    std::cerr << usage.what();
    return kUsage;
  } catch (const std::exception& failure) {
    std::cerr << "check: " << failure.what() << "\n";
    return kCannotCheck;
  }
}
