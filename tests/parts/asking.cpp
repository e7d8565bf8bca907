#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <exception>
#include <string>
#include <vector>

#include "cases.hpp"

namespace bounce::tests {
namespace {

struct Outcome {
  std::size_t wrong = 0;
  std::string told;  // the first wrong case, or the one at which the program ended
};

Outcome ask_all(const std::vector<Case>& cases, Ask ask) {
  Outcome outcome;
  for (const Case& c : cases) {
    bool ended = false;
    Problem problem;
    about_to_ask(c);
    try {
      problem = ask(c);
    } catch (const Ended& end) {
      problem.sentence = end.what();
      ended = true;
    } catch (const std::exception& thrown) {
      problem.sentence = thrown.what();
    }
    if (!problem.empty() && (outcome.wrong++ == 0 || ended)) {
      outcome.told = (outcome.wrong == 1 ? "the first: " : "the last: ") + c.name +
                     (c.hidden ? " (a hidden case)" : "") + "\n" + c.input + "\n" +
                     in_words(c, problem);
    }
    if (ended) break;
  }
  return outcome;
}

// Reports the first wrong case, and how many are wrong.
bool all_right(const std::vector<Case>& cases, Ask ask, const std::string& when) {
  const Outcome outcome = ask_all(cases, ask);
  if (outcome.wrong == 0) return true;
  ADD_FAILURE() << outcome.wrong << " of " << cases.size() << " cases wrong" << when
                << (when.empty() ? "; " : " ") << outcome.told;
  return false;
}

std::string running_check() {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  return std::string(test->test_suite_name()) + "." + test->name();
}

}  // namespace

void for_each_case(Ask ask) {
  std::vector<Case> cases = cases_of(running_check());
  if (!all_right(cases, ask, "")) return;
  std::reverse(cases.begin(), cases.end());
  all_right(cases, ask,
            " when asked again in another order, though right before: is something kept from one "
            "call to the next?");
}

void for_each_case_once(Ask ask) { all_right(cases_of(running_check()), ask, ""); }

}  // namespace bounce::tests
