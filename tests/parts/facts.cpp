#include "facts.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace bounce::tests {
namespace {

using json = nlohmann::ordered_json;  // as in cases.cpp, so that it is compiled once

json rows(const words::Rows& m) {
  json all = json::array();
  for (const std::vector<double>& row : m) {
    all.push_back(json::array());
    for (const double x : row) {
      const char* infinite = x > 0 ? "inf" : "-inf";
      all.back().push_back(std::isfinite(x) ? json(x) : std::isnan(x) ? "nan" : infinite);
    }
  }
  return all;
}

json values(const std::vector<words::Value>& values) {
  json all = json::array();
  for (const auto& [name, m, unit] : values)
    all.push_back({{"name", name}, {"rows", rows(m)}, {"unit", unit}});
  return all;
}

}  // namespace

std::string facts(const words::FailedCase& failed) {
  json quantities = json::array(), expected = json::array();
  for (const words::Quantity& q : failed.quantities) {
    quantities.push_back(
        {{"name", q.name}, {"unit", q.unit}, {"got", rows(q.got)}, {"right", q.right}});
    expected.push_back(rows(q.expected));
  }
  const json failure = {{"cases", failed.cases},         {"wrong", failed.wrong},
                        {"ended_at", failed.ended_at},   {"again", failed.again},
                        {"name", failed.name},           {"hidden", failed.hidden},
                        {"input", values(failed.input)}, {"parameters", values(failed.parameters)},
                        {"sentence", failed.sentence},   {"quantities", quantities}};
  const json answer = {{"contact", failed.contact}, {"expected", expected}};
  // A text may be that of a submission's exception, which may be invalid UTF-8.
  const auto replace = json::error_handler_t::replace;
  return json{{"failure", failure}, {"answer", answer}}.dump(-1, ' ', false, replace);
}

}  // namespace bounce::tests
