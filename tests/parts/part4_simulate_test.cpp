// Part 4: simulate. Each check is a fact about a whole trajectory, eq. (15). One checks the number
// of columns; the others check those of the first T that are there.
#include <stdexcept>
#include <utility>

#include "answers.hpp"
#include "checks.hpp"
#include "submission.hpp"

namespace bounce::tests {
namespace {

Problem problem(const std::string& sentence) { return {sentence, {}}; }

Trajectory ask_columns(Asker& asker, const Case& c) {
  return submission::first_columns(asker, c.q, c.v, c.params);
}

// Empty where columns of a long run are missing, or the only one: that is another check's.
Trajectory ask_columns_that_are_there(Asker& asker, const Case& c) {
  try {
    return ask_columns(asker, c);
  } catch (const submission::MissingColumns&) {
    if (!c.has_decidable_steps && c.params.T > 1) throw;
    return {};
  }
}

Trajectory ask_trajectory(Asker& asker, const Case& c) {
  return submission::simulate(asker, c.q, c.v, c.params);
}

Problem compare_column(const Case& c, Eigen::Index t, const State& right, const Trajectory& got) {
  const std::string in_column = " in column " + std::to_string(t);
  return both(compare(c, "q" + in_column, kConfiguration, right.q, got.q.col(t)),
              compare(c, "v" + in_column, kVelocity, right.v, got.v.col(t)));
}

// "; from column 20 on every entry is 0", if the trajectory ends like this.
std::string zeros_at_the_end(const Trajectory& got) {
  Eigen::Index column = got.q.cols();
  while (column > 0 && got.q.col(column - 1).isZero(0) && got.v.col(column - 1).isZero(0)) --column;
  return column == got.q.cols() || column == 0
             ? ""
             : "; from column " + std::to_string(column) + " on every entry is 0";
}

// Reports only the first wrong column, because one wrong step makes everything after it wrong.
Problem compare_columns(const Case& c, const Trajectory& got) {
  for (std::size_t i = 0; i < c.columns.size(); ++i) {
    const auto known = static_cast<Eigen::Index>(i);
    const std::string column = "column " + std::to_string(c.columns[i]);
    if (c.columns[i] >= got.q.cols()) return problem(column + " is missing");
    const State right{c.trajectory.q.col(known), c.trajectory.v.col(known)};
    Problem wrong = compare_column(c, c.columns[i], right, got);
    if (wrong.empty()) continue;
    const bool leaves_out = i > 0 && c.columns[i] > c.columns[i - 1] + 1;
    wrong.sentence = column + " is the first wrong one" +
                     (leaves_out ? " of those that are compared" : "") + zeros_at_the_end(got);
    return wrong;
  }
  return {};
}

Problem compare_start(const Case& c, const Trajectory& got) {
  return got.q.cols() > 0 ? compare_column(c, 0, {c.q, c.v}, got) : Problem();
}

// Compares column 0, and each other one with the step from the column before: the right step in the
// judge, and their own in a student's own build. For a long run, in which rounding errors grow too
// much for a stored trajectory.
Problem compare_steps(Asker& asker, const Case& c, const Trajectory& got) {
  const Problem start = compare_start(c, got);
  if (!start.empty()) return start;
  for (Eigen::Index t = 0; t + 1 < got.q.cols(); ++t) {
    State next;
    try {
      next = submission::step(asker, got.q.col(t), got.v.col(t), c.params);
    } catch (const std::runtime_error&) {
      if (!asker.was_undecided()) throw;
      continue;
    }
    Problem wrong = compare_column(c, t + 1, next, got);
    if (wrong.empty()) continue;
    wrong.sentence = "column " + std::to_string(t + 1) + " is not one step from the column before";
    return wrong;
  }
  return {};
}

Problem compare_all_columns(Asker& asker, const Case& c, const Trajectory& got) {
  return c.has_decidable_steps ? compare_steps(asker, c, got) : compare_columns(c, got);
}

// Asking throws unless both are 3xT.
Problem compare_size(const Case&, const Trajectory&) { return {}; }

using Twice = std::pair<Trajectory, Trajectory>;

Twice ask_twice(Asker& asker, const Case& c) {
  const Trajectory first = ask_columns(asker, c);
  return {first, ask_columns(asker, c)};
}

Problem compare_both(const Case&, const Twice& got) {
  const auto& [first, second] = got;
  if (!first.q.allFinite() || !first.v.allFinite()) {
    return problem("NaN or infinity in some column: was each one set?");
  }
  if (first.q.leftCols(1) == first.q.rightCols(1) || first.q.cwiseAbs().maxCoeff() > 1e6) {
    return problem("a last q that is the first one again, or a q beyond 1e6");
  }
  if (first.q != second.q || first.v != second.v) {
    return problem("a different trajectory when run a second time from the same start");
  }
  return {};
}

[[maybe_unused]] const bool kPart4IsAdded =
    register_call(
        4, [](Asker& asker, const Case& c) { return numbers_of(ask_trajectory(asker, c)); }) &&
    add_checks<Trajectory>("part4", ask_trajectory, {{"HasTColumns", compare_size}}) &&
    add_checks<Trajectory>("part4", ask_columns_that_are_there,
                           {{"StartsAtTheInitialState", compare_start},
                            {"StepsFromTheColumnBefore", compare_all_columns}}) &&
    add_checks<Trajectory>("part4", ask_columns, {{"PassesParametersOn", compare_columns}}) &&
    add_checks<Twice>("part4", ask_twice, {{"StaysFiniteOnALongRun", compare_both}}, true);

}  // namespace
}  // namespace bounce::tests
