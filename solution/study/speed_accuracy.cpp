#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "catalog.hpp"
#include "questions.hpp"

namespace bounce::study {
namespace {

constexpr int kRounds = 5;
constexpr double kLeastNs = 100'000;  // a timing lasts at least so long
constexpr double kFine = 1e-3;        // m

struct Point {
  const Method* method;
  double setting, error;
  long repeats;  // so that a timing lasts long enough
  std::vector<double> ns;
};

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

double time_once(const Scene& scene, const Point& point) {
  const double start = cpu_ns();
  for (long i = 0; i < point.repeats; ++i) point.method->run(scene, point.setting);
  return (cpu_ns() - start) / double(point.repeats);
}

std::vector<Point> points_of(const Scene& scene, const std::vector<Method>& all) {
  const Samples truth = truth_of(scene);
  std::vector<Point> points;
  for (const Method& method : all) {
    for (const double setting : method.settings) {
      Point point{&method, setting, error_of(scene, method.run(scene, setting), truth), 1, {}};
      point.repeats = std::max(1L, long(kLeastNs / std::max(time_once(scene, point), 100.0)));
      points.push_back(point);
    }
  }
  return points;
}

std::vector<const Point*> points_of_method(const std::vector<Point>& points,
                                           const std::string& name) {
  std::vector<const Point*> own;
  for (const Point& point : points)
    if (point.method->name == name) own.push_back(&point);
  return own;
}

double least_error(const std::vector<Point>& points, const std::string& name) {
  double least = std::numeric_limits<double>::infinity();
  for (const Point* point : points_of_method(points, name)) least = std::min(least, point->error);
  return least;
}

// The limit that holds here: the first whose cure, a method without it, is twice as good.
std::string limit_of(const std::vector<Point>& points, const Method& method) {
  for (const auto& [cure, limit] : method.limits)
    if (least_error(points, cure) < least_error(points, method.name) / 2) return limit;
  return "no method without its known limits does better";
}

// Why a method does not get to 1 mm here: it still converges, and needs a smaller step; or it has
// stalled.
std::string note_of(const std::vector<Point>& points, const Method& method) {
  const double least = least_error(points, method.name);
  if (least <= kFine) return "";
  const auto own = points_of_method(points, method.name);
  const Point &last = *own.back(), &before = *own[own.size() - 3];
  const double order =
      std::log(before.error / last.error) / std::log(before.setting / last.setting);
  char text[200];
  if (order > 0.4) {
    std::snprintf(text, sizeof text, "order %.1f: would need dt of %.0e s", order,
                  last.setting * std::pow(kFine / last.error, 1 / order));
  } else {
    std::snprintf(text, sizeof text, "stalls at %.0e m: %s", least,
                  limit_of(points, method).c_str());
  }
  return text;
}

}  // namespace

Table speed_accuracy(const Scenes& scenes) {
  Table table({"scene", "method", "setting", "setting_is", "ns_per_simulated_second", "ns_per_step",
               "error_m", "note"});
  const std::vector<Method> all = all_methods();
  for (const Scene& scene : scenes) {
    std::vector<Point> points = points_of(scene, all);
    for (int round = 0; round < kRounds; ++round)
      for (Point& point : points) point.ns.push_back(time_once(scene, point));
    for (const Point& point : points) {
      const bool steps = point.method->has_step;
      const double setting = steps ? fitting_step(scene, point.setting) : point.setting;
      const double ns = median(point.ns) / scene.until;
      table.add(scene.name, point.method->name, setting, steps ? "dt_s" : "tolerance", ns,
                steps ? ns * setting : 0.0, point.error, note_of(points, *point.method));
    }
  }
  return table;
}

Table order(const Scenes& scenes) {
  Table table({"scene", "method", "dt_s", "error_m", "order"});
  for (const Scene& scene : scenes) {
    const Samples truth = truth_of(scene);
    for (const Method& method : all_methods()) {
      if (!method.has_step) continue;
      double before = 0;
      for (double dt = 0.01; dt > 2e-6; dt /= 2) {
        const double error = error_of(scene, method.run(scene, dt), truth);
        const double seen = before > 0 && error > 0 ? std::log2(before / error) : 0.0;
        table.add(scene.name, method.name, fitting_step(scene, dt), error, seen);
        before = error;
      }
    }
  }
  return table;
}

}  // namespace bounce::study
