#include "checks.hpp"

#include <gtest/gtest.h>

#include <exception>
#include <utility>

namespace bounce::tests {
namespace {

// Compares the answers to all cases, which were asked once or once more. An exception is a wrong
// answer. The failure has no wrong case if all are right.
Failure compare_all(Asker& asker, const CheckAnswers& asked, bool again, Reporter& reporter) {
  const auto& outcomes = again ? asked.again : asked.first;
  Failure failure;
  failure.cases = asked.cases.size();
  failure.again = again;
  std::size_t asked_cases = 0;
  bool ends = false;
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    if (!outcomes[i]) continue;
    ++asked_cases;
    const Case& c = asked.cases[i];
    const Outcome& got = *outcomes[i];
    Problem problem{got.thrown, {}};
    if (got.answer.has_value()) {
      try {
        problem = asked.check.compare(asker, c, got.answer);
      } catch (const std::exception& thrown) {
        problem.sentence = thrown.what();
      }
    }
    if (asker.was_undecided() || got.undecided) {
      reporter.finds_undecided();
      continue;
    }
    if (problem.is_open) reporter.finds_open();
    if (problem.empty()) continue;
    const std::size_t number = again ? 2 * asked.cases.size() - 1 - i : i;
    if (failure.wrong == 0) reporter.finds_first_wrong(c, problem, number);
    if (failure.wrong == 0 || got.ended) {
      failure.asked = c;
      failure.problem = problem;
    }
    ends = ends || got.ended;
    ++failure.wrong;
  }
  if (ends) failure.ended_at = asked_cases;
  return failure;
}

template <class Matrix>
auto rows(const Matrix& m) {
  std::vector<std::vector<typename Matrix::Scalar>> all;
  for (Eigen::Index i = 0; i < m.rows(); ++i) {
    all.emplace_back();
    for (Eigen::Index j = 0; j < m.cols(); ++j) all.back().push_back(m(i, j));
  }
  return all;
}

std::vector<words::Value> input_of(const Case& c) {
  std::vector<words::Value> all;
  for (const std::string& name : c.input) {
    const bool is_q = name[0] == 'q';
    const char* unit = is_q ? kConfiguration : kVelocity;
    if (name == "J") {
      all.push_back({name, rows(c.J), "1, 1, m"});
    } else {
      all.push_back({name, rows(is_q ? c.q : c.v), unit});
    }
  }
  return all;
}

std::vector<words::Value> values_of(const Parameters& p) {
  const auto one = [](double x) { return words::Rows{{x}}; };
  return {{"l", one(p.l), "m"},         {"m", one(p.m), "kg"},
          {"mu", one(p.mu), ""},        {"epsilon", one(p.epsilon), ""},
          {"g", rows(p.g), "m/s^2"},    {"dt", one(p.dt), "s"},
          {"delta", one(p.delta), "m"}, {"T", one(p.T), p.T == 1 ? "column" : "columns"}};
}

// The parameters that differ from the assignment's, which a reader needs to know.
std::vector<words::Value> others(const Parameters& params) {
  std::vector<words::Value> all = values_of(params), usual = values_of({}), other;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].rows != usual[i].rows) other.push_back(all[i]);
  }
  return other;
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
  const auto& [c, problem, cases, wrong, ended_at, again] = failure;
  words::FailedCase failed{
      cases,    wrong,    ended_at,         again, c.name, input_of(c), others(c.params),
      c.hidden, c.corner, problem.sentence, {}};
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
