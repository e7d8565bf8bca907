#include "facts.hpp"

#include <cmath>

namespace bounce::judge {
namespace {

using nlohmann::json;

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

}  // namespace

json facts(const tests::Failure& failure) {
  const words::FailedCase failed = tests::failed_case(failure);
  json all = {{"cases", failed.cases},       {"wrong", failed.wrong},
              {"ended_at", failed.ended_at}, {"again", failed.again},
              {"name", failed.name},         {"input", failed.input},
              {"hidden", failed.hidden},     {"contact", failed.contact},
              {"sentence", failed.sentence}, {"quantities", json::array()}};
  for (const words::Quantity& q : failed.quantities) {
    all["quantities"].push_back({{"name", q.name},
                                 {"unit", q.unit},
                                 {"got", rows(q.got)},
                                 {"right", q.right},
                                 {"expected", rows(q.expected)}});
  }
  return all;
}

}  // namespace bounce::judge
