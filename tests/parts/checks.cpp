#include "checks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <exception>
#include <tuple>
#include <utility>

#include "smallest.hpp"

namespace bounce::tests {
namespace {

// What there is to say of an answer, as of one that an exception stands for. Empty if it is right.
Problem problem_of(Asker& asker, const Check& check, const Case& c, const Outcome& got) {
  if (!got.answer.has_value()) return {got.thrown, {}};
  try {
    return check.compare(asker, c, got.answer);
  } catch (const std::exception& thrown) {
    return {thrown.what(), {}};
  }
}

// How early a wrong case is reported: by a hidden one only where no public one has a wrong number.
auto rank_of(const Case& c, const Problem& problem) {
  const bool has_numbers = !problem.differences.empty();
  return std::tuple(!has_numbers, c.hidden, has_numbers ? complexity(c) : Complexity());
}

bool is_zero(const Problem& problem) {
  const auto is = [](const Difference& difference) { return difference.got.isZero(0); };
  return !problem.differences.empty() &&
         std::all_of(problem.differences.begin(), problem.differences.end(), is);
}

// Compares the answers to all cases, which were asked once or once more. An exception is a wrong
// answer. The failure has no wrong case if all are right.
Failure compare_all(Asker& asker, const CheckAnswers& asked, bool again, Reporter& reporter) {
  const auto& outcomes = again ? asked.again : asked.first;
  Failure failure;
  failure.cases = asked.cases.size();
  failure.again = again;
  std::size_t asked_cases = 0, number = 0;
  bool ends = false;
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    if (!outcomes[i]) continue;
    ++asked_cases;
    const Case& c = asked.cases[i];
    const Outcome& got = *outcomes[i];
    const Problem problem = problem_of(asker, asked.check, c, got);
    if (asker.was_undecided() || got.undecided) {
      reporter.finds_undecided();
      continue;
    }
    if (problem.is_open) reporter.finds_open();
    if (problem.empty()) continue;
    const bool is_first = failure.wrong++ == 0;
    const bool is_simpler =
        is_first || rank_of(c, problem) < rank_of(failure.asked, failure.problem);
    failure.always_zero = (is_first || failure.always_zero) && is_zero(problem);
    ends = ends || got.ended;
    if (!got.ended && (ends || !is_simpler)) continue;
    failure.asked = c;
    failure.problem = problem;
    number = again ? 2 * asked.cases.size() - 1 - i : i;
  }
  if (failure.wrong == 0) return failure;
  failure.always_zero = failure.always_zero && failure.wrong == asked_cases;
  if (ends) failure.ended_at = asked_cases;
  const auto& [c, problem] = std::tie(failure.asked, failure.problem);
  reporter.finds_wrong(c, problem, number);
  if (!again && !c.hidden && !problem.differences.empty())
    failure.smallest = smallest_of(asker, c, problem);
  return failure;
}

class Test : public testing::Test {
 public:
  using Asked = std::function<CheckAnswers(const Check&)>;
  Test(const Check& check, Asker& asker, Reporter& reporter, Asked asked)
      : check_(check), asker_(asker), reporter_(reporter), asked_(std::move(asked)) {}

 private:
  const Check& check_;
  Asker& asker_;
  Reporter& reporter_;
  Asked asked_;

  // That a case is right once and wrong the other time is told only if all were right at first.
  void TestBody() override {
    const CheckAnswers asked = asked_(check_);
    Failure failure = compare_all(asker_, asked, false, reporter_);
    if (failure.wrong == 0) failure = compare_all(asker_, asked, true, reporter_);
    if (failure.wrong > 0) ADD_FAILURE() << reporter_.fails(failure);
  }
};

}  // namespace

std::vector<Check>& checks() {
  static std::vector<Check> all;
  return all;
}

CheckAnswers::CheckAnswers(const Check& asked_check)
    : check(asked_check), cases(cases_of(check.id())), first(cases.size()), again(cases.size()) {}

words::FailedCase failed_case(const Failure& failure) {
  const auto& [c, problem, cases, wrong, ended_at, again, always_zero, smallest] = failure;
  const auto [input, parameters] = question_of(c);
  words::FailedCase failed{cases,   wrong,      ended_at, again,    always_zero,      c.name,
                           input,   parameters, c.hidden, c.corner, problem.sentence, {},
                           smallest};
  for (const auto& [name, unit, expected, got] : problem.differences) {
    failed.quantities.push_back(
        {name, unit, rows(got), rows(expected), rows(agrees(c, expected, got))});
  }
  return failed;
}

Outcome ask(Asker& asker, const Check& check, const Case& c) {
  Outcome outcome;
  try {
    outcome.answer = check.ask(asker, c);
  } catch (const Ended& end) {
    outcome.thrown = end.why;
    outcome.ended = true;
  } catch (const std::exception& thrown) {
    outcome.thrown = thrown.what();
  }
  outcome.undecided = asker.was_undecided();
  return outcome;
}

CheckAnswers ask_forth_and_back(Asker& asker, const Check& check, Reporter& reporter) {
  CheckAnswers asked(check);
  const std::size_t cases = asked.cases.size();
  for (std::size_t k = 0; k < (check.asks_once ? cases : 2 * cases); ++k) {
    const std::size_t i = k < cases ? k : 2 * cases - 1 - k;
    const std::size_t place = k < cases ? k + 1 : k + 1 - cases;  // in its round
    reporter.asks({asked.cases[i], {}, cases, 1, place, k >= cases});
    (k < cases ? asked.first : asked.again)[i] = ask(asker, check, asked.cases[i]);
  }
  return asked;
}

int run_checks(Asker& asker, Reporter& reporter,
               const std::function<CheckAnswers(const Check&)>& asked) {
  for (const Check& check : checks()) {
    testing::RegisterTest(check.part.c_str(), check.name.c_str(), nullptr, nullptr, __FILE__,
                          __LINE__,
                          [&]() -> Test* { return new Test(check, asker, reporter, asked); });
  }
  return RUN_ALL_TESTS();
}

}  // namespace bounce::tests
