#include <algorithm>
#include <set>

#include "findings.hpp"

namespace bounce::tests {
namespace {

// A program may number them otherwise.
const std::string kNumbered = " Corners are numbered as in eq. (3).";

std::set<double> values(const std::string& name, const Columns& columns) {
  const Column& column = columns.at(name);
  return {column.begin(), column.end()};
}

}  // namespace

Words corners(const WrongPart& part) {
  if (!std::all_of(part.got.begin(), part.got.end(), is_finite)) return {};
  const auto each = [&](const std::string& condition) {
    return (value(condition, part.columns) != 0).all();
  };
  const std::set<double> chosen = values("chosen", part.columns);
  const bool one_corner = each("taken = phi_of");
  if (!each("-1 < taken") || each("taken = 0")) return {};
  if (values("corner", part.columns).size() < 4) return {};
  // Always the same quarters further: a formula says that better.
  const bool one_turn = values("taken", part.columns).size() == 1;
  if (each("taken = 2") || (one_turn && !one_corner)) return {};
  if (chosen.size() == 1) {
    return {(one_corner ? "Your answer" : "Your J") + std::string(" is always that of corner ") +
            digits(*chosen.begin()) + "." + kNumbered};
  }
  if (!one_corner) {
    if (!each("phi_of = 0")) return {};
    return {
        "phi is that of the lowest corner, and your J is that of another one in some questions."};
  }
  Words never;
  for (const double corner : {1, 2, 3, 4}) {
    if (chosen.count(corner) == 0) never.push_back(digits(corner));
  }
  if (never.size() == 1) {
    const bool by_others = each("(taken = 0) + (taken = next)");
    return {"Corner " + never[0] + " is never chosen, also where it is the lowest" +
            (by_others ? "; your answer is that of the lowest of the others." : ".") + kNumbered};
  }
  if (!never.empty()) {
    return {"Corners " + joined(never) + " are never chosen, also where they are the lowest." +
            kNumbered};
  }
  for (const auto& [words, condition] : alternatives("taken")) {
    if (each(condition)) return {"Your answer is always that of the " + words + "."};
  }
  return {"Each answer is that of a corner, but not always of the lowest one."};
}

}  // namespace bounce::tests
