#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <exception>
#include <string>
#include <utility>
#include <vector>

#include "cases.hpp"

namespace bounce::tests {
namespace {

struct Outcome {
  std::size_t right = 0, wrong = 0, undecided = 0;
  bool ended = false;
  std::string told;  // the first wrong case, or the one at which the program ended
};

Outcome answered;  // of the cases before the one that is asked

Outcome ask_all(const std::vector<Case>& cases, Ask ask, bool tells) {
  Outcome outcome;
  for (const Case& c : cases) {
    Problem problem;
    answered = outcome;
    about_to_ask(c);
    try {
      problem = ask(c);
    } catch (const Ended& end) {
      problem.sentence = end.what();
      outcome.ended = true;
    } catch (const std::exception& thrown) {
      problem.sentence = thrown.what();
    }
    if (std::exchange(asked_what_is_not_recorded, false)) {
      ++outcome.undecided;
      continue;
    }
    outcome.right += problem.empty();
    if (!problem.empty() && (outcome.wrong++ == 0 || outcome.ended) && tells) {
      outcome.told = (outcome.ended ? "the last: " : "the first: ") + c.name +
                     (c.hidden ? " (a hidden case)" : "") + "\n" + c.input + "\n" +
                     in_words(c, problem);
    }
    if (outcome.ended) break;
  }
  return outcome;
}

// "2 of 9 cases wrong"; or where the program ended, which is asked no more.
std::string counts(const Outcome& outcome, std::size_t cases) {
  const std::string of = " of " + std::to_string(cases);
  if (!outcome.ended) return std::to_string(outcome.wrong) + of + " cases wrong";
  const std::string before = answered_before();
  return "ended at case " + std::to_string(outcome.right + outcome.wrong + outcome.undecided) + of +
         (before.empty() ? "" : ", with " + before + " before it");
}

// Reports the first wrong case, and how many are wrong, unless the check has failed before. Returns
// whether the program can be asked more.
bool ask_and_report(const std::vector<Case>& cases, Ask ask, const std::string& when) {
  const bool tells = !testing::Test::HasFailure();
  const Outcome outcome = ask_all(cases, ask, tells);
  if (outcome.wrong > 0 && tells) {
    ADD_FAILURE() << counts(outcome, cases.size()) << when << (when.empty() ? "; " : " ")
                  << outcome.told;
  }
  if (outcome.undecided > 0) testing::Test::RecordProperty(kUndecided, "");
  return !outcome.ended;
}

std::string running_check() {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  return std::string(test->test_suite_name()) + "." + test->name();
}

}  // namespace

std::string answered_before() {
  const std::string right = std::to_string(answered.right) + " right";
  const std::string wrong = std::to_string(answered.wrong) + " wrong";
  if (answered.wrong == 0) return answered.right == 0 ? "" : right;
  return answered.right == 0 ? wrong : right + " and " + wrong;
}

void for_each_case(Ask ask) {
  std::vector<Case> cases = cases_of(running_check());
  if (!ask_and_report(cases, ask, "")) return;
  std::reverse(cases.begin(), cases.end());
  ask_and_report(
      cases, ask,
      " when asked again in another order, though right before: is something kept from one "
      "call to the next?");
}

void for_each_case_once(Ask ask) { ask_and_report(cases_of(running_check()), ask, ""); }

}  // namespace bounce::tests
