#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>

#include "catalog.hpp"
#include "questions.hpp"
#include "timing.hpp"

namespace bounce::study {
namespace {

constexpr double kFine = 1e-3;  // m

struct Point {
  const Method* method;
  Setting at;
};

std::vector<Point> points_of(const Scene& scene, const std::vector<Method>& all) {
  StartsOfScene starts(scene);
  std::vector<Point> points;
  for (const Method& method : all) {
    for (const double setting : method.settings)
      points.push_back({&method, measure(method, setting, starts)});
  }
  return points;
}

Job job_of(const Scene& scene, const Method& method, double setting, int samples = kSamples) {
  return {[&scene, &method, setting, samples] { method.simulate(scene, setting, samples); }};
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
  for (const Point* point : points_of_method(points, name))
    least = std::min(least, point->at.error.rms);
  return least;
}

double least_error_under(const Scene& scene, const Method& method, methods::ImpactLaw law) {
  const Samples truth = truth_under(law, scene);
  double least = std::numeric_limits<double>::infinity();
  for (const double setting : method.settings)
    least = std::min(least, error_of(scene, method.run(scene, setting), truth));
  return least;
}

// The limit that holds here: the first whose cure is twice as good.
std::string limit_of(const Scene& scene, const std::vector<Point>& points, const Method& method) {
  for (const Limit& limit : method.limits) {
    const double cured = limit.cure == method.name ? least_error_under(scene, method, limit.law)
                                                   : least_error(points, limit.cure);
    if (cured < least_error(points, method.name) / 2) return limit.words;
  }
  return "the reason is not known";
}

// Why a method does not get to 1 mm here: it still converges, and needs a smaller step; or it has
// stalled.
std::string note_of(const Scene& scene, const std::vector<Point>& points, const Method& method) {
  const double least = least_error(points, method.name);
  if (least <= kFine) return "";
  const auto own = points_of_method(points, method.name);
  const Point &last = *own.back(), &before = *own[own.size() - 1 - kStepsPerDecade];
  const double order =
      std::log(before.at.error.rms / last.at.error.rms) / std::log(before.at.value / last.at.value);
  char text[200];
  if (order > 0.4) {
    std::snprintf(text, sizeof text, "order %.1f: would need dt of %.0e s", order,
                  last.at.value * std::pow(kFine / last.at.error.rms, 1 / order));
  } else {
    std::snprintf(text, sizeof text, "stalls at %.0e m: %s", least,
                  limit_of(scene, points, method).c_str());
  }
  return text;
}

}  // namespace

Table speed_accuracy(const Scenes& scenes, const Extent& extent) {
  Table table({"scene", "method", "setting", "setting_is", "ns_per_simulated_second", "ns_per_step",
               "error_m", "least_error_m", "largest_error_m", "own_error_m", "note"});
  const std::vector<Method> all = all_methods();
  for (const Scene& scene : scenes) {
    const std::vector<Point> points = points_of(scene, all);
    std::vector<Job> jobs;
    jobs.reserve(points.size());
    for (const Point& point : points)
      jobs.push_back(job_of(scene, *point.method, point.at.value, point.at.samples));
    time_in_turn(jobs, extent);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Point& point = points[i];
      const double ns = quantile(jobs[i].ns) / scene.until;
      const Errors& error = point.at.error;
      const bool steps = point.method->has_step;
      table.add(scene.name, point.method->name, point.at.value, steps ? "dt_s" : "tolerance", ns,
                steps ? std::optional(ns * point.at.value) : std::nullopt, error.rms, error.least,
                error.largest, error.own, note_of(scene, points, *point.method));
    }
  }
  return table;
}

Table speed_ratios(const Scenes& scenes, const Extent& extent) {
  Table table({"scene", "method", "setting", "setting_is", "times_of_assignment", "lower_quartile",
               "upper_quartile"});
  constexpr double kStep = 1e-3, kTolerance = 1e-6;
  const std::vector<Method> all = all_methods();
  for (const Scene& scene : scenes) {
    std::vector<Job> jobs;
    jobs.reserve(all.size());
    for (const Method& method : all)
      jobs.push_back(job_of(scene, method, method.has_step ? kStep : kTolerance));
    time_in_turn(jobs, extent);
    for (std::size_t i = 0; i < all.size(); ++i) {
      const std::vector<double> times = ratios(jobs[i], jobs[0]);
      const bool steps = all[i].has_step;
      table.add(scene.name, all[i].name, steps ? fitting_step(scene, kStep) : kTolerance,
                steps ? "dt_s" : "tolerance", quantile(times), quantile(times, 0.25),
                quantile(times, 0.75));
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
        std::optional<double> seen;
        if (before > 0 && error > 0) seen = std::log2(before / error);
        table.add(scene.name, method.name, fitting_step(scene, dt), error, seen);
        before = error;
      }
    }
  }
  return table;
}

}  // namespace bounce::study
