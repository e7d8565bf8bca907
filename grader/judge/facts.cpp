#include "facts.hpp"

#include <cmath>

namespace bounce::judge {
namespace {

using nlohmann::json;

json number(double x) {
  if (std::isnan(x)) return "nan";
  if (std::isinf(x)) return x > 0 ? "inf" : "-inf";
  return x;
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

json quantity(const tests::Case& c, const tests::Difference& d) {
  return {{"name", d.name},
          {"unit", d.unit},
          {"got", rows(d.got, number)},
          {"right", rows(tests::agrees(c, d.expected, d.got), [](bool is) { return is; })},
          {"expected", rows(d.expected, number)}};
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
  for (const tests::Difference& d : problem.differences)
    all["quantities"].push_back(quantity(c, d));
  return all;
}

}  // namespace bounce::judge
