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
  std::size_t wrong = 0, undecided = 0;
  bool ended = false;
  std::string told;  // the first wrong case, or the one at which the program ended
};

Outcome ask_all(const std::vector<Case>& cases, Ask ask, bool tells) {
  Outcome outcome;
  for (const Case& c : cases) {
    Problem problem;
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
    if (!problem.empty() && (outcome.wrong++ == 0 || outcome.ended) && tells) {
      outcome.told = (outcome.wrong == 1 ? "the first: " : "the last: ") + c.name +
                     (c.hidden ? " (a hidden case)" : "") + "\n" + c.input + "\n" +
                     in_words(c, problem);
    }
    if (outcome.ended) break;
  }
  return outcome;
}

// Reports the first wrong case, and how many are wrong, unless the check has failed before. Returns
// whether the program can be asked more.
bool ask_and_report(const std::vector<Case>& cases, Ask ask, const std::string& when) {
  const bool tells = !testing::Test::HasFailure();
  const Outcome outcome = ask_all(cases, ask, tells);
  if (outcome.wrong > 0 && tells) {
    ADD_FAILURE() << outcome.wrong << " of " << cases.size() << " cases wrong" << when
                  << (when.empty() ? "; " : " ") << outcome.told;
  }
  if (outcome.undecided > 0) testing::Test::RecordProperty(kUndecided, "");
  return !outcome.ended;
}

std::string running_check() {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  return std::string(test->test_suite_name()) + "." + test->name();
}

}  // namespace

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
