#include "speed_accuracy.hpp"

#include <algorithm>

namespace bounce::study {
namespace {

struct Point {
  const Method* method;
  Setting at;
};

std::vector<Point> points_of(const Scene& scene, const Methods& methods) {
  StartsOfScene starts(scene);
  std::vector<Point> points;
  for (const Method& method : methods) {
    for (const double setting : method.settings)
      points.push_back({&method, measure(method, setting, starts)});
  }
  return points;
}

Job job_for(const Scene& scene, const Point& point) {
  const Method* method = point.method;
  const double value = point.at.value;
  const int samples = point.at.samples;
  if (method->time) {
    return {[=, &scene](long repeats) { return method->time(scene, value, repeats); }};
  }
  return job_of([=, &scene] { method->simulate(scene, value, samples); });
}

}  // namespace

Table speed_accuracy(const std::vector<Scene>& scenes, const Methods& methods,
                     const Extent& extent) {
  Table table({"scene", "method", "setting", "ns_per_simulated_second", "error_m", "own_error_m"});
  for (const Scene& scene : scenes) {
    const std::vector<Point> points = points_of(scene, methods);
    std::vector<Job> jobs;
    jobs.reserve(points.size());
    for (const Point& point : points) jobs.push_back(job_for(scene, point));
    time_in_turn(jobs, extent);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto& [method, at] = points[i];
      table.add(scene.name, method->name, at.value, quantile(jobs[i].ns) / scene.until,
                at.error.rms, at.error.own);
    }
  }
  return table;
}

}  // namespace bounce::study
