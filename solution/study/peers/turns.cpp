#include "turns.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bounce::study {
namespace {

Quartiles quartiles_of(std::vector<double> values) {
  values.erase(
      std::remove_if(values.begin(), values.end(), [](double value) { return std::isnan(value); }),
      values.end());
  return {quantile(values, 0.25), quantile(values), quantile(values, 0.75)};
}

struct Turn {
  long repeats;
  int every;
};

Turn turn_of(const Point& point, const Extent& extent) {
  double once = point.time(1);
  if (once < kLongNs) once = std::max(point.time(1), 20.0);  // the first found caches cold
  return {std::max(1L, std::lround(extent.least_ns / once)), once > kLongNs ? kLongEvery : 1};
}

}  // namespace

void time_in_turns(std::vector<Point>& points, const Extent& extent) {
  std::vector<Turn> turns;
  turns.reserve(points.size());
  for (const Point& point : points) turns.push_back(turn_of(point, extent));
  for (int round = 0; round < extent.rounds; ++round) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto [repeats, every] = turns[i];
      points[i].ns.push_back(round % every == 0 ? points[i].time(repeats) / double(repeats)
                                                : std::numeric_limits<double>::quiet_NaN());
    }
  }
}

Quartiles times_of(const Point& point) { return quartiles_of(point.ns); }

Quartiles ratios_of(const Point& point, const Point& other) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < point.ns.size(); ++i) ratios.push_back(point.ns[i] / other.ns[i]);
  return quartiles_of(ratios);
}

}  // namespace bounce::study
