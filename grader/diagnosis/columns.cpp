#include <cmath>
#include <numbers>

#include "findings.hpp"
#include "recognise.hpp"

namespace bounce::tests {

std::vector<Input> inputs_of(const Case& c) {
  const Parameters& p = c.params;
  const double g = p.g(0) + 100 * p.g(1);
  return {{"l", p.l},    {"m", p.m},       {"mu", p.mu},       {"epsilon", p.epsilon},
          {"g", g},      {"dt", p.dt},     {"delta", p.delta}, {"x", c.q(0)},
          {"y", c.q(1)}, {"theta", c.q(2)}};
}

// The others are made of these, as tables.txt says.
Columns columns_of(int part, const Cases& cases, const Answers& right, const Answers& got) {
  Columns columns;
  for (std::size_t k = 0; k < cases.size(); ++k) {
    const auto set = [&](const std::string& name, double x) {
      Column& column = columns[name];
      if (column.size() == 0) column.setConstant(Eigen::Index(cases.size()), NAN);
      column(Eigen::Index(k)) = x;
    };
    const auto set_each = [&](const std::string& name, const Eigen::VectorXd& numbers) {
      for (Eigen::Index i = 0; i < numbers.size(); ++i) set(name + std::to_string(i), numbers(i));
    };
    const Case& c = cases[k];
    for (const auto& [name, x] : inputs_of(c)) set(name, x);
    for (const auto& [name, x] : inputs_of({})) set(std::string("usual_") + name, x);
    set("pi", std::numbers::pi);
    set("T", c.params.T);
    set_each("q", c.q);
    set_each("v", c.v);
    set_each("g", c.params.g);
    set_each("J", Eigen::Map<const Eigen::VectorXd>(c.J.data(), c.J.size()));
    set_each("r", right[k].numbers);
    const Eigen::VectorXd none = Eigen::VectorXd::Constant(right[k].numbers.size(), NAN);
    set_each("a", got[k].thrown.empty() ? got[k].numbers : none);
  }
  for (const std::string& list : {std::string("names"), "names" + std::to_string(part)}) {
    const std::string names = text_of(rows_of("lists")[0], list);
    for (const auto& [id, name, formula] : alternatives(names))
      columns[name] = value(formula, columns);
  }
  return columns;
}

}  // namespace bounce::tests
