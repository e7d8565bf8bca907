// The graded checks: how each case is asked, and how its answer is compared afterwards.
//
// Asking and comparing are apart. While it is asked, a program can measure how long it takes until
// the next question; if its answers were compared meanwhile, a wrong one would take longer, and the
// program would learn what it got wrong and guess again. So the judge asks all cases of all checks
// of a part, in an order that no answer changes, once more in reverse, and only then compares. A
// student's own build asks and compares check by check, so that a crash costs one check.
#pragma once

#include <any>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cases.hpp"
#include "failed_case.hpp"
#include "submission.hpp"

namespace bounce::tests {

using submission::Asker;

struct Check {
  std::string part, name;  // "part1", "TurnsHoweverFar"; its id has a dot between
  // Asks the questions of a case: which, and how many, doesn't depend on the answers.
  std::function<std::any(Asker&, const Case&)> ask;
  std::function<Problem(Asker&, const Case&, const std::any&)> compare;
  bool asks_once = false;  // it asks twice by itself

  std::string id() const { return part + "." + name; }
};

// All checks that are linked in, in the order in which they were added.
std::vector<Check>& checks();

// A row of a part's checks, as they are written down.
template <class Answer>
struct CheckRow {
  CheckRow(const char* check, Problem (*compare_answer)(const Case& c, const Answer& got))
      : name(check),
        compare([=](Asker&, const Case& c, const Answer& got) { return compare_answer(c, got); }) {}
  CheckRow(const char* check, Problem (*ask_and_compare)(Asker&, const Case& c, const Answer& got))
      : name(check), compare(ask_and_compare) {}

  const char* name;
  std::function<Problem(Asker& asker, const Case& c, const Answer& got)> compare;
};

// Adds checks that all ask in the same way. Returns true.
template <class Answer>
bool add_checks(const std::string& part, Answer (*ask)(Asker&, const Case&),
                const std::vector<CheckRow<Answer>>& rows, bool asks_once = false) {
  for (const auto& [name, compare] : rows) {
    const auto compare_any = [compare = compare](Asker& asker, const Case& c, const std::any& got) {
      return compare(asker, c, std::any_cast<const Answer&>(got));
    };
    checks().push_back({part, name, ask, compare_any, asks_once});
  }
  return true;
}

// What a program answered to a case.
struct Outcome {
  std::any answer;         // empty if it gave none
  std::string thrown;      // the text of the exception in place of an answer; or of how it ended
  bool ended = false;      // it can be asked no more questions of this check
  bool undecided = false;  // recorded answers didn't hold what it asked
};

// A check with the answers to its cases, in the cases' order: empty where one wasn't asked.
struct CheckAnswers {
  explicit CheckAnswers(const Check& asked_check);
  const Check& check;
  std::vector<Case> cases;  // public ones first
  std::vector<std::optional<Outcome>> first, again;
};

// What a failed check reports: of the cases with a wrong number the simplest, a public one if there
// is one; if none has one, the first wrong case; or the one at which the program ended.
struct Failure {
  Case asked;
  Problem problem;
  std::size_t cases = 0;     // of the check
  std::size_t wrong = 0;     // of these
  std::size_t ended_at = 0;  // how many were asked until the program ended, with the last; else 0
  bool again = false;        // it was right when it was asked before, in another order
  bool always_zero = false;  // each case is wrong, and every wrong number is 0
  std::optional<words::Smallest> smallest =
      {};  // of `asked`, if a number is wrong and it is public
};

// The same, as reports say it (grader/words).
words::FailedCase failed_case(const Failure& failure);

// Is told what happens while a check is asked and compared. GoogleTest is told only that the check
// failed: its messages are for people, and no program reads them, since their wording changes from
// version to version.
struct Reporter {
  virtual ~Reporter() = default;
  // Before each case: what the check would report if the program ended now.
  virtual void asks(const Failure&) {}
  // The wrong case to report, and its number in the order of the calls of `asks`.
  virtual void finds_wrong(const Case&, const Problem&, std::size_t) {}
  virtual void finds_undecided() {}
  virtual void finds_open() {}  // Problem::is_open
  // Returns what GoogleTest shows to whoever runs the tests by hand.
  virtual std::string fails(const Failure& failure) = 0;
};

// Thrown by a submission that can answer no more questions of this check. Whoever catches a
// question's std::exception lets it pass.
struct Ended {
  std::string why;
};

// An exception is an answer, too.
Outcome ask(Asker& asker, const Check& check, const Case& c);

// Asks all cases of a check, and once more in reverse order.
CheckAnswers ask_forth_and_back(Asker& asker, const Check& check, Reporter& reporter);

// Makes a test of each check, whose answers `asked` gives, and runs GoogleTest's tests, as its
// filter selects them. Returns RUN_ALL_TESTS().
int run_checks(Asker& asker, Reporter& reporter,
               const std::function<CheckAnswers(const Check&)>& asked);

}  // namespace bounce::tests
