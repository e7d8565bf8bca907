#include "ratios.hpp"

namespace bounce::study {
namespace {

constexpr double kTolerances[] = {1e-2, 1e-3, 1e-4, 1e-5, 1e-6};  // m

// The fastest point within an error for which `may` holds; null if there is none.
template <class May>
const Point* fastest(const std::vector<Point>& points, double error, const May& may) {
  const Point* best = nullptr;
  for (const Point& point : points) {
    if (!may(point) || !(point.error.rms <= error)) continue;
    if (!best || times_of(point).median < times_of(*best).median) best = &point;
  }
  return best;
}

void add_row(Table& table, const std::string& scene, const std::vector<Point>& points,
             const char* within, double error, const Point& peer) {
  const Point* ours = fastest(points, error, [](const Point& p) { return !p.is_peer; });
  if (!ours) {
    table.add(scene, within, error, peer.method, peer.setting, "", "", "", "", "");
    return;
  }
  const Quartiles times = ratios_of(peer, *ours);
  table.add(scene, within, error, peer.method, peer.setting, ours->method, ours->setting,
            times.median, times.lower, times.upper);
}

std::vector<std::string> peers_of(const std::vector<Point>& points) {
  std::vector<std::string> names;
  for (const Point& point : points) {
    if (point.is_peer && (names.empty() || names.back() != point.method))
      names.push_back(point.method);
  }
  return names;
}

}  // namespace

Table empty_ratios() {
  return Table({"scene", "within", "error_m", "engine", "engine_dt_s", "ours", "ours_setting",
                "times", "lower_quartile", "upper_quartile"});
}

void add_ratios(Table& table, const std::string& scene, const std::vector<Point>& points) {
  for (const Point& point : points)
    if (point.is_peer) add_row(table, scene, points, "peer's own", point.error.rms, point);
  for (const double tolerance : kTolerances) {
    for (const std::string& name : peers_of(points)) {
      const Point* peer =
          fastest(points, tolerance, [&](const Point& p) { return p.method == name; });
      if (peer) add_row(table, scene, points, "tolerance", tolerance, *peer);
    }
  }
}

}  // namespace bounce::study
