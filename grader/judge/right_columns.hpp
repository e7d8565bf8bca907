// Whether the columns of a trajectory are right, each as the step from the one before: over a whole
// trajectory rounding errors grow too much for a comparison.
#pragma once

#include <bounce/part3_step.hpp>
#include <optional>

#include "../../solution/fixtures/decidable.hpp"

namespace bounce::judge {

inline constexpr double kTolerance = 1e-9;  // that of the fixtures
// What rounding decides may go either way within decidable.hpp's margin of 1e-6; the answers for
// starts so near differ by some hundred times that, or belong to another contact.
inline constexpr double kAside = 2e-6;
inline constexpr double kLoose = 2e-4;
// Columns of a trajectory that may come about in this way. A program that rounds otherwise has one
// now and then; more of them in a row would be a motion of its own.
inline constexpr int kMostAside = 3;

// As tests/parts/cases.cpp compares; NaN is never right.
inline bool is_near(const Vector3& expected, const Vector3& got, double tolerance) {
  return ((got - expected).array().abs() <= tolerance * expected.array().abs().max(1.0)).all();
}

inline bool are_same(const State& expected, const State& got, double tolerance) {
  return is_near(expected.q, got.q, tolerance) && is_near(expected.v, got.v, tolerance);
}

// Whether rounding decides the step, and some start beside this one leads there: a little higher or
// lower, so that it touches or not, or turned a little, so that another corner is the lowest.
inline bool may_lead_to(const State& now, const State& from, const Parameters& params) {
  if (fixtures::mode_of_step(from, params)) return false;
  for (const double up : {0.0, kAside, -kAside}) {
    for (const double turn : {0.0, kAside, -kAside}) {
      const Vector3 aside = from.q + Vector3(0, up, turn / params.l);
      if (are_same(step(aside, from.v, params), now, kLoose)) return true;
    }
  }
  return false;
}

// The first column that isn't the solution's step from the column before, or for column 0 not
// `start`. Where rounding decides what happens in a step (decidable.hpp), a column is also right if
// it is the solution's step from a state that differs by as little.
inline std::optional<Eigen::Index> wrong_column(const Trajectory& trajectory, const State& start,
                                                const Parameters& params) {
  State before = start, expected = start;
  int aside = 0;
  for (Eigen::Index column = 0; column < trajectory.q.cols(); ++column) {
    const State now{trajectory.q.col(column), trajectory.v.col(column)};
    if (!now.q.allFinite() || !now.v.allFinite()) return column;
    if (!are_same(expected, now, kTolerance)) {
      if (column == 0 || !may_lead_to(now, before, params) || ++aside > kMostAside) return column;
    }
    before = now;
    expected = step(now.q, now.v, params);
  }
  return std::nullopt;
}

}  // namespace bounce::judge
