#include "facts.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace bounce::judge {
namespace {

using nlohmann::json;

json number(double x) {
  if (std::isnan(x)) return "nan";
  if (std::isinf(x)) return x > 0 ? "inf" : "-inf";
  return x;
}

// Rounds to six digits, more than a picture shows.
json drawn(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", x);
  return number(std::strtod(text, nullptr));
}

template <class Matrix, class Entry>
json rows(const Matrix& m, Entry entry) {
  json all = json::array();
  for (Eigen::Index i = 0; i < m.rows(); ++i) {
    json row = json::array();
    for (Eigen::Index j = 0; j < m.cols(); ++j) row.push_back(entry(m(i, j)));
    all.push_back(row);
  }
  return all;
}

json list(const Vector3& x) { return {x(0), x(1), x(2)}; }

json quantity(const tests::Case& c, const tests::Difference& d) {
  return {{"name", d.name},
          {"unit", d.unit},
          {"got", rows(d.got, number)},
          {"right", rows(tests::agrees(c, d.expected, d.got), [](bool is) { return is; })},
          {"expected", rows(d.expected, number)}};
}

json scene(const tests::Case& c) {
  const Parameters& p = c.params;
  return {{"l", p.l},         {"m", p.m},       {"g", list(p.g)}, {"dt", p.dt},
          {"delta", p.delta}, {"q", list(c.q)}, {"v", list(c.v)}};
}

json path(const tests::Case& c, const tests::Problem& problem) {
  const auto columns = std::min<Eigen::Index>(c.columns.back() + 1, problem.path.cols());
  return {{"first", problem.column},
          {"got", rows(problem.path.leftCols(columns).transpose(), drawn)},
          {"columns", c.columns},
          {"expected", rows(c.trajectory.q.transpose(), drawn)}};
}

}  // namespace

json facts(const tests::Failure& failure) {
  const auto& [c, problem, cases, wrong, ended_at, again] = failure;
  json all = {{"cases", cases},
              {"wrong", wrong},
              {"ended_at", ended_at},
              {"again", again},
              {"name", c.name},
              {"input", c.input},
              {"hidden", c.hidden},
              {"contact", c.corner},
              {"sentence", problem.sentence},
              {"quantities", json::array()}};
  for (const tests::Difference& d : problem.differences) {
    all["quantities"].push_back(quantity(c, d));
  }
  if (!c.q.isZero(0)) all["scene"] = scene(c);
  if (problem.path.cols() > 0) all["path"] = path(c, problem);
  return all;
}

json facts(const Termination& end) {
  return {{"what", end.what}, {"number", end.number}, {"text", end.text}};
}

}  // namespace bounce::judge
