// Runs the tests with the code under test linked in, on the public fixtures only.
//
//   part1_contacts_test [--notes FOLDER PRINTED [STACK] | --mistake FILE | --debug]
//
// With --notes, it writes a file for each check, named after the check: "running" while it runs,
// then "passed" or "failed" and the feedback, or "undecided" if no case is wrong, but the given
// earlier parts were asked what isn't recorded. After this word come the sizes of PRINTED, the file
// of standard output, before and after the reported case. A check that already has its file isn't
// run again, so that after a crash a second run continues with the next one; STACK then tells where
// it came. A check that takes too long ends the program. With --mistake no test runs: it writes to
// FILE which mistakes the answers to all public cases point to. With --debug it stops in the
// debugger at the first wrong case, then asks it once more.
#include <gtest/gtest.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <utility>

#include "answers.hpp"
#include "checks.hpp"
#include "crash.hpp"
#include "linked.hpp"
#include "paths.hpp"  // which CMakeLists.txt makes
#include "recognise.hpp"
#include "time_limit.hpp"

namespace bounce::tests {

std::vector<std::filesystem::path> fixture_folders() { return {BOUNCE_FIXTURES}; }

namespace {

// The name of a case, and below it what is asked.
std::string question(const Case& c) { return c.name + words::indented("\n  input    ", c.input); }

// Nothing ends a program here but its own process, which reports no failure then.
std::string in_words(const Failure& failure) { return words::lines(failed_case(failure), true); }

struct ByHand : Reporter {
  std::string fails(const Failure& failure) override { return in_words(failure); }
};

// Stops at the first wrong case: set a breakpoint in the part, and continue. The case is asked
// again.
struct Debugged : ByHand {
  void finds_first_wrong(const Case& c, const Problem& problem, std::size_t) override {
    const std::string numbers = words::numbers(failed_case({c, problem}), true);
    std::cout << question(c) << "\n" << numbers << std::endl;
#ifdef _WIN32
    __debugbreak();
#else
    std::raise(SIGTRAP);
#endif
    answers(linked_parts.front() - '0', {c});
    std::exit(1);
  }
};

// Writes a file for each check, as the first lines of this file say.
class Notes : public testing::EmptyTestEventListener, public Reporter {
 public:
  Notes(std::string folder, std::string printed)
      : folder_(std::move(folder)), printed_(std::move(printed)) {}

 private:
  std::filesystem::path folder_;
  std::filesystem::path printed_;  // where standard output goes
  std::string check_;              // the running one
  std::string asked_;              // the question that is being answered
  std::string text_;               // of the failure
  std::vector<std::string> from_;  // the sizes of standard output before each question, behind ""
  std::string from_to_;            // these sizes before and after the reported case
  bool is_undecided_ = false;

  void asks(const Case& c) override {
    asked_ = question(c);
    from_.push_back(bytes_printed());
    note("running" + from_.back(), asked_);
  }

  void finds_first_wrong(const Case&, const Problem&, std::size_t number) override {
    from_.push_back(bytes_printed());
    from_to_ = from_[number + 1] + from_[number + 2];
  }

  void finds_undecided() override { is_undecided_ = true; }

  std::string fails(const Failure& failure) override { return text_ = in_words(failure); }

  void OnTestStart(const testing::TestInfo& test) override {
    check_ = std::string(test.test_suite_name()) + "." + test.name();
    text_ = from_to_ = "";
    from_ = {""};
    is_undecided_ = false;
    note("running", "");
    limit_time([this] { note("hung" + from_.back(), asked_); });
  }

  void OnTestEnd(const testing::TestInfo& test) override {
    lift_time_limit();
    const auto& result = *test.result();
    if (result.Failed() && text_.empty()) text_ = result.GetTestPartResult(0).message();
    note(result.Failed() ? "failed" + from_to_ : is_undecided_ ? "undecided" : "passed", text_);
  }

  std::string bytes_printed() const {
    std::cout.flush();
    std::error_code unknown;
    const auto size = std::filesystem::file_size(printed_, unknown);
    return " " + std::to_string(unknown ? 0 : size);
  }

  void note(const std::string& status, const std::string& text) const {
    std::ofstream(folder_ / check_) << status << "\n" << text << "\n";
  }
};

// GoogleTest's pattern for all tests but the checks of parts that aren't linked in.
std::string those_of_linked_parts() {
  std::string others = "*-";
  for (char part = '1'; part <= '9'; ++part) {
    if (linked_parts.find(part) == std::string::npos) others += std::string("part") + part + ".*:";
  }
  return others;
}

// Of these, the checks that have no note yet.
std::string those_left(const std::filesystem::path& notes) {
  std::string pattern = those_of_linked_parts();
  for (const auto& file : std::filesystem::directory_iterator(notes)) {
    pattern += file.path().filename().string() + ":";
  }
  return pattern;
}

int run(Reporter& reporter) {
  return run_checks(reporter,
                    [&](const Check& check) { return ask_forth_and_back(check, reporter); });
}

int take_notes(const std::string& folder, const std::string& printed) {
  std::setvbuf(stdout, nullptr, _IONBF, 0);  // so that a crash loses no output
  testing::GTEST_FLAG(filter) = those_left(folder);
  auto& listeners = testing::UnitTest::GetInstance()->listeners();
  delete listeners.Release(listeners.default_result_printer());
  auto* notes = new Notes(folder, printed);
  listeners.Append(notes);
  return run(*notes);
}

std::string in_words(const Mistake& m) {
  std::string equations;
  for (const int number : m.equations) {
    equations += (equations.empty() ? "(" : ", (") + std::to_string(number) + ")";
  }
  return m.title + ". " + m.sentence + " See " + (m.equations.size() == 1 ? "eq. " : "eqs. ") +
         equations + " and hint " + m.hint + ".\n";
}

// One paragraph per line: the known mistakes that the answers to the public cases point to; or, if
// there are none, the patterns in the numbers. Empty if there is nothing to say.
std::string mistakes_in_words(int part) {
  const std::vector<Case> cases = questions(part);
  const auto [mistakes, patterns] = diagnosis(part, cases, answers(part, cases));
  std::string text;
  if (mistakes.size() == 1) text = "This looks like a known mistake.\n";
  if (mistakes.size() == 2) text = "This looks like two known mistakes at once.\n";
  for (const Mistake& mistake : mistakes) text += in_words(mistake);
  for (const std::string& sentence : patterns) text += sentence + "\n";
  return text;
}

void write_mistakes(const std::string& file) {
  limit_time([] {});
  std::ofstream out(file);
  for (const char part : linked_parts) out << mistakes_in_words(part - '0');
  lift_time_limit();
}

}  // namespace
}  // namespace bounce::tests

int main(int argc, char** argv) {
  testing::GTEST_FLAG(filter) = bounce::tests::those_of_linked_parts();  // unless another is given
  testing::InitGoogleTest(&argc, argv);
  const std::string option = argc > 1 ? argv[1] : "";
  if (option == "--mistake" && argc > 2) {
    bounce::tests::write_mistakes(argv[2]);
    return 0;
  }
  if (option == "--notes" && argc > 4) bounce::runner::report_crashes(argv[4]);
  if (option == "--notes" && argc > 3) return bounce::tests::take_notes(argv[2], argv[3]);
  bounce::tests::ByHand by_hand;
  bounce::tests::Debugged debugged;
  return bounce::tests::run(option == "--debug" ? static_cast<bounce::tests::Reporter&>(debugged)
                                                : by_hand);
}
