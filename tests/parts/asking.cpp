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

constexpr const char* kAgain =
    " when asked again in another order, though right before: is something kept from one call to "
    "the next? ";

Reporter* told = nullptr;  // by run_checks

// Asks the cases in their order. The failure has no wrong case if all are right.
Failure ask_all(const std::vector<Case>& cases, Ask ask) {
  Failure failure;
  failure.cases = cases.size();
  for (std::size_t i = 0; i < cases.size() && failure.ended_at == 0; ++i) {
    const Case& c = cases[i];
    Problem problem;
    told->asks(c);
    try {
      problem = ask(c);
    } catch (const Ended& end) {
      problem.sentence = end.why;
      failure.ended_at = i + 1;
    } catch (const std::exception& thrown) {
      problem.sentence = thrown.what();
    }
    if (std::exchange(asked_what_is_not_recorded, false)) {
      told->finds_undecided();
    } else if (!problem.empty()) {
      if (failure.wrong == 0 && !testing::Test::HasFailure()) told->finds_first_wrong(c, problem);
      if (failure.wrong == 0 || failure.ended_at > 0) {
        failure.asked = c;
        failure.problem = problem;
      }
      ++failure.wrong;
    }
  }
  return failure;
}

// Reports the first wrong case, unless the check has failed before. Returns whether the program can
// be asked more.
bool ask_and_report(const std::vector<Case>& cases, Ask ask, bool again) {
  Failure failure = ask_all(cases, ask);
  if (again) failure.again = kAgain;
  if (failure.wrong > 0 && !testing::Test::HasFailure()) ADD_FAILURE() << told->fails(failure);
  return failure.ended_at == 0;
}

std::string running_check() {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  return std::string(test->test_suite_name()) + "." + test->name();
}

}  // namespace

int run_checks(Reporter& reporter) {
  told = &reporter;
  return RUN_ALL_TESTS();
}

void for_each_case(Ask ask) {
  std::vector<Case> cases = cases_of(running_check());
  if (!ask_and_report(cases, ask, false)) return;
  std::reverse(cases.begin(), cases.end());
  ask_and_report(cases, ask, true);
}

void for_each_case_once(Ask ask) { ask_and_report(cases_of(running_check()), ask, false); }

}  // namespace bounce::tests
