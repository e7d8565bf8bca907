// Runs the tests with the code under test linked in, on the public fixtures only.
//
//   part1_contacts_test [--notes FOLDER PRINTED [STACK] | --mistake FILE STEM CHECK | --debug]
//
// With --notes, it writes a file for each check, named after the check: "running" while it runs,
// then "passed" or "failed" and the feedback; or, if no case is wrong, but the given earlier parts
// were asked what isn't recorded, "undecided", or "open" where that followed a right answer. After
// this word come the sizes of PRINTED, the file of standard output, before and after the reported
// case; and what there is to report also stands as facts in a file beside it (facts.hpp). A check
// that already has its file isn't run again, so that after a crash a second run continues with the
// next one; STACK then tells where it came. A check that takes too long ends the program. With
// --mistake no test runs: it writes to FILE the heading of the hint for the check, in the hints of
// STEM, and what the answers to all public cases tell of the mistake; and to FILE.json the same as
// facts (recognise.hpp). With --debug it stops in the debugger at the simplest wrong case, then
// asks it once more.
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
#include "facts.hpp"
#include "linked.hpp"
#include "paths.hpp"  // which CMakeLists.txt makes
#include "recognise.hpp"
#include "report.hpp"
#include "time_limit.hpp"

namespace bounce::tests {

namespace {

Linked own;  // the parts of this program

// Nothing ends a program here but its own process, which reports no failure then.
std::string in_words(const Failure& failure) { return words::lines(failed_case(failure), true); }

struct ByHand : Reporter {
  std::string fails(const Failure& failure) override { return in_words(failure); }
};

// Stops at the simplest wrong case: set a breakpoint in the part, and continue. The case is asked
// again.
struct Debugged : ByHand {
  void finds_wrong(const Case& c, const Problem& problem, std::size_t) override {
    const words::FailedCase failed = failed_case({c, problem});
    std::cout << words::question(failed) << "\n" << words::numbers(failed, true) << std::endl;
#ifdef _WIN32
    __debugbreak();
#else
    std::raise(SIGTRAP);
#endif
    answers(own, linked_parts.front() - '0', {c});
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
  bool is_undecided_ = false, is_open_ = false;

  void asks(const Failure& if_it_ends) override {
    asked_ = in_words(if_it_ends);
    from_.push_back(bytes_printed());
    note("running" + from_.back(), asked_);
    note_facts(if_it_ends);
  }

  void finds_wrong(const Case&, const Problem&, std::size_t number) override {
    from_.push_back(bytes_printed());
    from_to_ = from_[number + 1] + from_[number + 2];
  }

  void finds_undecided() override { is_undecided_ = true; }

  void finds_open() override { is_open_ = true; }

  std::string fails(const Failure& failure) override {
    note_facts(failure);
    return text_ = in_words(failure);
  }

  void OnTestStart(const testing::TestInfo& test) override {
    check_ = std::string(test.test_suite_name()) + "." + test.name();
    text_ = from_to_ = "";
    from_ = {""};
    is_undecided_ = is_open_ = false;
    note("running", "");
    limit_time([this] { note("hung" + from_.back(), asked_); });
  }

  void OnTestEnd(const testing::TestInfo& test) override {
    lift_time_limit();
    const auto& result = *test.result();
    if (result.Failed() && text_.empty()) text_ = result.GetTestPartResult(0).message();
    note(result.Failed() ? "failed" + from_to_
         : is_undecided_ ? "undecided"
         : is_open_      ? "open"
                         : "passed",
         text_);
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

  void note_facts(const Failure& failure) const {
    std::ofstream(folder_ / (check_ + ".json")) << facts(failed_case(failure)) << "\n";
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
    if (file.path().extension() != ".json") pattern += file.path().filename().string() + ":";
  }
  return pattern;
}

int run(Reporter& reporter) {
  return run_checks(own, reporter,
                    [&](const Check& check) { return ask_forth_and_back(own, check, reporter); });
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

words::MistakeFacts facts_of(const Mistake& m) {
  return {m.title, m.sentence, m.hint, m.equations, m.checks};
}

// One paragraph per line: the known mistakes that the answers to the public cases point to; or, if
// there are none, the patterns in the numbers. Empty if there is nothing to say.
std::string in_words(const Diagnosis& found) {
  std::string text;
  if (found.mistakes.size() == 1) text = "This looks like a known mistake.\n";
  if (found.mistakes.size() == 2) text = "This looks like two known mistakes at once.\n";
  for (const Mistake& m : found.mistakes)
    text += m.title + ". " + m.sentence + " See " + words::where_to_read(facts_of(m)) + ".\n";
  for (const Pattern& pattern : found.patterns) text += sentence_of(pattern) + "\n";
  return text;
}

void write_mistakes(const std::string& file, const std::string& stem, const std::string& check) {
  limit_time([] {});
  const int part = linked_parts.front() - '0';
  const std::vector<Case> cases = questions(part);
  const Diagnosis found = diagnosis(part, cases, answers(own, part, cases));
  words::PartFacts facts_of_part;
  facts_of_part.stem = stem;
  facts_of_part.patterns = found.patterns;
  for (const Mistake& m : found.mistakes) facts_of_part.mistakes.push_back(facts_of(m));
  const std::string hint = words::first_hint(facts_of_part, check).heading;
  std::ofstream(file) << hint << "\n" << in_words(found);
  std::ofstream(file + ".json") << facts(found);
  lift_time_limit();
}

}  // namespace
}  // namespace bounce::tests

int main(int argc, char** argv) {
  bounce::tests::fixture_folders = {BOUNCE_FIXTURES};
  bounce::runner::ask_earlier_part = bounce::tests::recorded_answer;
  testing::GTEST_FLAG(filter) = bounce::tests::those_of_linked_parts();  // unless another is given
  testing::InitGoogleTest(&argc, argv);
  const std::string option = argc > 1 ? argv[1] : "";
  if (option == "--mistake" && argc > 4) {
    bounce::tests::write_mistakes(argv[2], argv[3], argv[4]);
    return 0;
  }
  if (option == "--notes" && argc > 4) bounce::runner::report_crashes(argv[4]);
  if (option == "--notes" && argc > 3) return bounce::tests::take_notes(argv[2], argv[3]);
  bounce::tests::ByHand by_hand;
  bounce::tests::Debugged debugged;
  return bounce::tests::run(option == "--debug" ? static_cast<bounce::tests::Reporter&>(debugged)
                                                : by_hand);
}
