#include "right_steps.hpp"

#include <bounce/part3_step.hpp>

#include "../../solution/fixtures/decidable.hpp"

namespace bounce::judge {
namespace {

constexpr double kTolerance = 1e-9;  // as in the fixtures

// Compares as tests/parts/cases.cpp does; NaN is never right.
bool is_near(const Vector3& expected, const Vector3& got) {
  return ((got - expected).array().abs() <= kTolerance * expected.array().abs().max(1.0)).all();
}

bool are_same(const State& expected, const State& got) {
  return is_near(expected.q, got.q) && is_near(expected.v, got.v);
}

bool is_decidable(const State& from, const Parameters& params) {
  return fixtures::mode_of_step(from.q, from.v, params).has_value();
}

}  // namespace

std::optional<Eigen::Index> wrong_column(const Trajectory& trajectory, const State& start,
                                         const Parameters& params) {
  State before = start;
  for (Eigen::Index column = 0; column < trajectory.q.cols(); ++column) {
    const State now{trajectory.q.col(column), trajectory.v.col(column)};
    const State expected = column == 0 ? start : step(before.q, before.v, params);
    if (!now.q.allFinite() || !now.v.allFinite()) return column;
    if (!are_same(expected, now) && (column == 0 || is_decidable(before, params))) return column;
    before = now;
  }
  return std::nullopt;
}

}  // namespace bounce::judge
