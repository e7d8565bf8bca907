// judge --part N [--given] [--sanitized] [--boxed] [--recognise] [--cpu-seconds S] [--seconds S]
//       --fixtures FOLDER... -- COMMAND...
//
// Runs the tests of part N against the runner that COMMAND starts, and prints one JSON object:
//   {"checks": [{"id", "passed", "status", "ended", "by", "stack", "failure"}],
//    "largest_error": number or null, "mistakes": [name], "patterns": [sentence]}
// ended says how the program ended, if it did, by what explains a crash, and stack where it came
// (termination.hpp). failure is the failed case in numbers (facts.hpp), with the expected
// answers of hidden cases, which students must not see; null if the check passed, or failed as a
// whole. largest_error is the largest in public cases, to two digits. mistakes and patterns are
// empty unless --recognise is given and a check failed; then a second runner is asked the public
// cases.
//
// judge --answers --part N ... prints the runner's answers to the public cases (answers_json.hpp).
//
// --boxed: COMMAND is a box (grader/box/enter.cpp), which reports when it is made. --seconds and
// --cpu-seconds are for the whole part; checks that there is no time left for fail.
//
// Exit status: 0 if every check has a verdict; 3, with a sentence on standard error, if the kit
// itself failed, which is no verdict about the submission.
#include <gtest/gtest.h>

#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>

#include "../diagnosis/pattern.hpp"
#include "../diagnosis/recognise.hpp"
#include "answers_json.hpp"
#include "facts.hpp"
#include "session.hpp"

namespace bounce {

static std::vector<std::filesystem::path> fixtures;
std::vector<std::filesystem::path> tests::fixture_folders() { return fixtures; }
void tests::about_to_ask(const Case&) {}

namespace judge {
namespace {

using nlohmann::json;

json reported;  // of the running check, if it failed
constexpr const char* kReported = "reported";

struct Options {
  std::uint32_t part = 0;
  bool given = false;
  Limits limits;
  bool recognise = false;
  bool answers = false;
  std::vector<std::string> command;
};

Options read_options(const std::vector<std::string>& arguments) {
  Options options;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (arguments[i] == "--part") {
      options.part = static_cast<std::uint32_t>(std::stoul(arguments.at(++i)));
    } else if (arguments[i] == "--given") {
      options.given = true;
    } else if (arguments[i] == "--sanitized") {
      options.limits.sanitized = true;
    } else if (arguments[i] == "--boxed") {
      options.limits.boxed = true;
    } else if (arguments[i] == "--cpu-seconds") {
      options.limits.session_cpu_seconds = std::stoi(arguments.at(++i));
    } else if (arguments[i] == "--seconds") {
      options.limits.session_seconds = std::stoi(arguments.at(++i));
      options.limits.wall_seconds =
          std::min(options.limits.wall_seconds, options.limits.session_seconds);
    } else if (arguments[i] == "--recognise") {
      options.recognise = true;
    } else if (arguments[i] == "--answers") {
      options.answers = true;
    } else if (arguments[i] == "--fixtures") {
      fixtures.emplace_back(arguments.at(++i));
    } else if (arguments[i] == "--") {
      options.command.assign(arguments.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                             arguments.end());
      break;
    } else {
      throw std::runtime_error("unknown option " + arguments[i]);
    }
  }
  if (options.part == 0 || options.command.empty() || fixtures.empty()) {
    throw std::runtime_error("usage: judge --part N [--given] --fixtures FOLDER... -- COMMAND...");
  }
  return options;
}

// Collects a verdict for each check. A test that fails other than by reporting a case is a fault of
// the kit.
class Verdicts : public testing::EmptyTestEventListener {
 public:
  json checks = json::array();
  std::string kit_failure;

 private:
  void OnTestStart(const testing::TestInfo&) override { reported = nullptr; }

  void OnTestEnd(const testing::TestInfo& test) override {
    for (int i = 0; i < test.result()->total_part_count(); ++i) {
      const std::string message = test.result()->GetTestPartResult(i).message();
      if (message != std::string("Failed\n") + kReported) kit_failure = message;
    }
    const bool passed = test.result()->Passed();
    const auto end = session->take_end().value_or(Session::End{{"graded", ""}, false});
    checks.push_back({{"id", std::string(test.test_suite_name()) + "." + test.name()},
                      {"passed", passed},
                      {"status", end.status},
                      {"ended", end.sentence},
                      {"by", end.by},
                      {"stack", end.stack},
                      {"failure", passed || end.of_no_case ? json() : reported}});
  }
};

// The answers of a new runner to the public cases. It has been asked nothing else before.
std::vector<tests::Answer> fresh_answers(const Options& options,
                                         const std::vector<tests::Case>& questions) {
  Session fresh(options.command, options.limits, options.part, options.given);
  session = &fresh;
  const int part = static_cast<int>(options.part);
  auto got = tests::answers(part, questions);
  if (!fresh.kit_failure().empty()) throw std::runtime_error(fresh.kit_failure());
  return got;
}

// Whether to look for known mistakes: not if the program ended while it was tested, as that says
// enough.
bool may_be_a_mistake(const json& checks) {
  bool failed = false;
  for (const json& check : checks) {
    if (check["status"] != "graded") return false;
    failed = failed || !check["passed"];
  }
  return failed;
}

void recognise(const Options& options, json& result) {
  const int part = static_cast<int>(options.part);
  const auto file = tests::public_file(part, "mistakes");
  if (!file) throw std::runtime_error("there are no known mistakes: run ./kit fixtures");
  std::ifstream in(*file);
  const tests::KnownMistakes known = tests::read_mistakes(in, part);
  const std::vector<tests::Case> questions = tests::questions(part);
  const std::vector<tests::Answer> got = fresh_answers(options, questions);
  for (const auto& mistake : tests::recognise(known, got))
    result["mistakes"].push_back(mistake.name);
  if (!result["mistakes"].empty()) return;
  result["patterns"] = tests::patterns(part, questions, known.right, got);
}

int print_answers(const Options& options) {
  const auto questions = tests::questions(static_cast<int>(options.part));
  std::cout << answers_json(fresh_answers(options, questions)).dump() << std::endl;
  return std::cout ? 0 : 3;
}

// Rounds to two digits; null if it isn't finite.
json rounded(double error) {
  if (!std::isfinite(error)) return nullptr;
  char digits[16];
  std::snprintf(digits, sizeof digits, "%.1e", error);
  return std::strtod(digits, nullptr);
}

int run(const Options& options) {
  Session asked(options.command, options.limits, options.part, options.given);
  session = &asked;
  testing::GTEST_FLAG(filter) = "part" + std::to_string(options.part) + ".*";
  auto& listeners = testing::UnitTest::GetInstance()->listeners();
  delete listeners.Release(listeners.default_result_printer());
  auto* verdicts = new Verdicts;
  listeners.Append(verdicts);
  if (RUN_ALL_TESTS() != 0 && verdicts->checks.empty()) {
    throw std::runtime_error("no test ran");
  }
  if (!asked.kit_failure().empty()) throw std::runtime_error(asked.kit_failure());
  if (!verdicts->kit_failure.empty()) throw std::runtime_error(verdicts->kit_failure);

  json result = {{"checks", verdicts->checks},
                 {"largest_error", rounded(tests::largest_error())},
                 {"mistakes", json::array()},
                 {"patterns", json::array()}};
  if (options.recognise && may_be_a_mistake(verdicts->checks)) recognise(options, result);
  // A message may hold the text of a submission's exception, which may be invalid UTF-8.
  std::cout << result.dump(-1, ' ', false, json::error_handler_t::replace) << std::endl;
  return std::cout ? 0 : 3;
}

}  // namespace
}  // namespace judge

void tests::found_wrong(const Case&, const Problem&) {}

std::string tests::in_words(const Failure& failure) {
  judge::reported = judge::facts(failure);
  return judge::kReported;
}

}  // namespace bounce

int main(int argc, char** argv) try {
  std::signal(SIGPIPE, SIG_IGN);  // that a runner has ended is noticed by reading from it
  bounce::judge::stay_on_this_cpu();
  int one = 1;
  testing::InitGoogleTest(&one, argv);
  const auto options = bounce::judge::read_options({argv + 1, argv + argc});
  return options.answers ? bounce::judge::print_answers(options) : bounce::judge::run(options);
} catch (const std::exception& e) {
  std::cerr << "judge: " << e.what() << std::endl;
  return 3;
}
