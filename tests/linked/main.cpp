// The tests of a build that has the code under test linked in: public fixtures only.
//
//   part1_contacts_test [--notes FOLDER | --mistake FILE]
//
// With --notes a file is written for each check, named as the check is: "running" while it runs,
// then "passed" or "failed", and what there is to say. A check that has its note already isn't run
// again, so that after a crash a second run goes on with the next one; and one that takes too long
// ends the program. With --mistake no test runs: the file gets what the answers to all public cases
// tell of the mistake behind them.
#include <gtest/gtest.h>

#include <fstream>

#include "../feedback.hpp"
#include "mistake.hpp"
#include "time_limit.hpp"

namespace bounce::tests {

std::vector<std::filesystem::path> fixture_folders() { return {BOUNCE_FIXTURES}; }

std::string in_words(const Case& c, const Problem& problem) { return feedback(c, problem); }

namespace {

std::filesystem::path notes;  // the folder; empty without --notes
std::string check;            // the one that runs

void note(const std::string& status, const std::string& text) {
  std::ofstream(notes / check) << status << "\n" << text << "\n";
}

class Notes : public testing::EmptyTestEventListener {
  void OnTestStart(const testing::TestInfo& test) override {
    check = std::string(test.test_suite_name()) + "." + test.name();
    note("running", "");
    limit_time([] { note("hung", asked); });
  }

  void OnTestEnd(const testing::TestInfo& test) override {
    lift_time_limit();
    std::string text;
    for (int i = 0; i < test.result()->total_part_count(); ++i) {
      text += test.result()->GetTestPartResult(i).message();
    }
    const std::string prefix = "Failed\n";
    if (text.rfind(prefix, 0) == 0) text.erase(0, prefix.size());
    note(test.result()->Passed() ? "passed" : "failed", text);
  }

 public:
  static inline std::string asked;  // the question that is being answered
};

// The checks that have no note yet, in GoogleTest's words.
std::string those_left() {
  std::string done;
  for (const auto& file : std::filesystem::directory_iterator(notes)) {
    done += (done.empty() ? "-" : ":") + file.path().filename().string();
  }
  return "*" + done;
}

void take_notes(const std::string& folder) {
  notes = folder;
  testing::GTEST_FLAG(filter) = those_left();
  auto& listeners = testing::UnitTest::GetInstance()->listeners();
  delete listeners.Release(listeners.default_result_printer());
  listeners.Append(new Notes);
}

void write_mistakes(const std::string& file) {
  limit_time([] {});
  std::ofstream(file) << mistakes_in_words();
  lift_time_limit();
}

}  // namespace

void about_to_ask(const Case& c) {
  if (notes.empty()) return;
  Notes::asked = c.name + "\n" + c.input;
  note("running", Notes::asked);
}

}  // namespace bounce::tests

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  const std::string option = argc == 3 ? argv[1] : "";
  if (option == "--mistake") {
    bounce::tests::write_mistakes(argv[2]);
    return 0;
  }
  if (option == "--notes") bounce::tests::take_notes(argv[2]);
  return RUN_ALL_TESTS();
}
