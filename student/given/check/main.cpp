// Builds what has changed, runs the public checks part by part, and shows the first thing to do.
// ./check and check.cmd start it; README.md says what it can do.
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <set>
#include <thread>

#include "files.hpp"
#include "process.hpp"
#include "report.hpp"

namespace bounce::check {
namespace {

constexpr int kAllPass = 0, kSomethingFails = 1, kUsage = 2, kCannotCheck = 3;
const std::filesystem::path kOptions = "given/check/options.txt";

struct Options {
  int part = 0;                 // 0: all
  std::string record;           // the file of the score record; empty if none is wanted
  std::set<std::string> words;  // of options.txt
  bool has(const std::string& word) const { return words.count(word) == 1; }
};

// 2 of "2", "part2", "part2_lcp" or "src/part2_lcp.cpp"; 0 of another word.
int number_of(const std::string& word, const std::vector<Part>& parts) {
  const std::string name = std::filesystem::path(word).stem().string();
  for (const Part& part : parts) {
    const std::string number = std::to_string(part.number);
    if (word == number || name == part.stem || name == "part" + number) return part.number;
  }
  return 0;
}

Options read_options(const std::vector<std::string>& words, const std::vector<Part>& parts) {
  Options options;
  for (auto next = words.begin(); next != words.end(); ++next) {
    const std::string& word = *next;
    const int part = number_of(word, parts);
    if (part && options.part) {
      throw Failure("one part at a time, or all: ./check " + std::to_string(part) + ", or ./check");
    }
    if (part) {
      options.part = part;
    } else if (word == "--json" && next + 1 != words.end()) {
      options.record = *++next;
      continue;
    } else if (!has(read(kOptions), "./check " + word + " ")) {
      std::cerr << "check: " << word << " is not known; there are:\n" << read(kOptions);
      std::exit(kUsage);
    }
    options.words.insert(word);
  }
  if (options.has("--sanitize") && !kHasSanitizers) {
    throw Failure("--sanitize needs g++ or clang on Linux or macOS");
  }
  if (options.has("--real") && options.part && options.part != 2) {
    throw Failure("--real asks part 2: ./check 2 --real, or ./check --real");
  }
  return options;
}

Run built_and_run(const Options& options) {
  Run run = read_run(options.part, options.has("--sanitize"));
  build_parts(run);
  run_parts(run);
  return run;
}

void print_score(const Run& run) {
  std::cout << "Score on the public checks: " << run.score << " / " << run.possible << ".\n";
}

// Whether there is nothing to mend. The screen is cleared before the result, where that `replaces`
// another.
bool check(const Options& options, bool replaces = false) {
  std::filesystem::create_directories(kWork);
  const auto alone = lock(kWork / "lock");
  Run run = built_and_run(options);
  if (replaces && is_terminal()) std::cout << "\033[H\033[2J";
  if (!options.record.empty()) {
    write_record(run, options.record);
    print_score(run);
    return run.is_right();
  }
  const bool hints = options.has("--hint");
  if (hints) hint(run);
  const bool is_right = hints ? !run.first_part : report(run);
  const bool is_green = is_right && !options.part && !hints;
  if (options.has("--real")) ask_about_real_impacts(run);
  if (options.has("--study") || (is_green && !options.has("--real"))) {
    study(run, options.has("--study"));
  }
  if (is_green) {
    std::cout << "Watch it: cmake --build build, then ./build/bounce. Hand it in: ./check --zip.\n";
  }
  std::cout << std::flush;
  return is_right;
}

// Checks whenever a source changes, until the program is ended. Where one part was asked for and is
// right, the next follows at once, and all after the last.
[[noreturn]] void watch(Options options) {
  const int last = read_run(0, false).all.back().number;
  for (bool again = false;; again = true) {
    const std::string before = state_of_sources();
    try {
      for (bool replaces = again; check(options, replaces) && options.part; replaces = false) {
        const bool is_last = options.part == last;
        options.part = is_last ? 0 : options.part + 1;
        std::cout << heading(is_last ? "Now all parts together:"
                                     : "Now part " + std::to_string(options.part) + ":")
                  << std::endl;
      }
    } catch (const Failure& failure) {  // a file may be missing for a moment
      std::cout << "check: " << failure.what() << "\n";
    }
    std::cout << dim("Waiting for a change in src/; Ctrl-C ends it.") << std::endl;
    while (state_of_sources() == before)
      std::this_thread::sleep_for(std::chrono::milliseconds(300));
  }
}

// Whatever passes: what is written is handed in.
void zip() {
  namespace fs = std::filesystem;
  fs::remove("hand_in.zip");
  fs::create_directories(kWork);
  const auto alone = lock(kWork / "lock");
  std::set<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator("src")) {
    if (entry.is_regular_file()) files.insert(entry.path().generic_string());
  }
  if (fs::exists("examples.txt")) files.insert("examples.txt");
  std::vector<std::string> command{"cmake", "-E", "tar", "cf", "hand_in.zip", "--format=zip"};
  command.insert(command.end(), files.begin(), files.end());
  if (run(command, kWork / "zip.txt", Limits::none) != 0) throw Failure(read(kWork / "zip.txt"));
  std::cout << "hand_in.zip is what you hand in, where your course says. It holds:\n";
  for (const std::string& file : files) std::cout << "  " << file << "\n";
  std::cout << std::flush;
  print_score(built_and_run({}));
}

int run(const std::vector<std::string>& words) {
  if (words.size() == 1 && (words[0] == "-h" || words[0] == "--help")) {
    std::cout << read(kOptions);
    return kAllPass;
  }
  const Options options = read_options(words, read_run(0, false).all);
  if (options.has("--examples")) {
    return judge_examples(options.part, options.has("--hint")) ? kAllPass : kSomethingFails;
  }
  if (options.has("--watch")) watch(options);
  if (options.has("--zip")) {
    zip();
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
  } catch (const std::exception& failure) {
    std::cerr << "check: " << failure.what() << "\n";
    return kCannotCheck;
  }
}
