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

// {"q": [...], "v": [...], "J": [[...]], "params": {...}}
json question(const words::Question& asked) {
  json all, params = json::object();
  const auto plain = [](const words::Value& x) {
    const json m = rows(x.rows);
    if (x.rows.size() == 1 && x.rows[0].size() == 1) return m[0][0];
    json flat = json::array();
    for (const json& row : m) flat.push_back(row.size() == 1 ? row[0] : row);
    return flat;
  };
  for (const words::Value& x : asked.input) all[x.name] = plain(x);
  for (const words::Value& x : asked.parameters) params[x.name] = plain(x);
  all["params"] = params;
  return all;
}

json smallest_facts(const words::Smallest& smallest) {
  json on_the_way = json::array();
  for (const auto& [x, equation] : smallest.on_the_way)
    on_the_way.push_back(
        {{"name", x.name}, {"rows", rows(x.rows)}, {"unit", x.unit}, {"equation", equation}});
  return {{"before", smallest.before ? question(*smallest.before) : json()},
          {"input", question(smallest.asked)},
          {"quantity", smallest.expected.name},
          {"unit", smallest.expected.unit},
          {"expected", rows(smallest.expected.rows)},
          {"got", rows(smallest.got)},
          {"on_the_way", on_the_way}};
}

}  // namespace

std::string facts(const words::FailedCase& failed) {
  json quantities = json::array(), expected = json::array();
  for (const words::Quantity& q : failed.quantities) {
    quantities.push_back(
        {{"name", q.name}, {"unit", q.unit}, {"got", rows(q.got)}, {"right", q.right}});
    expected.push_back(rows(q.expected));
  }
  const json failure = {{"cases", failed.cases},
                        {"wrong", failed.wrong},
                        {"ended_at", failed.ended_at},
                        {"again", failed.again},
                        {"always_zero", failed.always_zero},
                        {"name", failed.name},
                        {"hidden", failed.hidden},
                        {"input", values(failed.input)},
                        {"parameters", values(failed.parameters)},
                        {"sentence", failed.sentence},
                        {"quantities", quantities}};
  const json answer = {{"contact", failed.contact}, {"expected", expected}};
  // A text may be that of a submission's exception, which may be invalid UTF-8.
  const auto replace = json::error_handler_t::replace;
  const json smallest = failed.smallest ? smallest_facts(*failed.smallest) : json();
  return json{{"failure", failure}, {"answer", answer}, {"smallest", smallest}}.dump(-1, ' ', false,
                                                                                     replace);
}

}  // namespace bounce::tests
