// How far a scheme is off depends on where within a step an impact falls: with one start, the error
// over the step is a saw-tooth of up to a factor of ten. So an error is the root of the mean square
// over several starts, which lie parts of a step apart along the true motion.
#include <algorithm>
#include <cmath>
#include <map>

#include "catalog.hpp"
#include "peers/engine.hpp"
#include "questions.hpp"

namespace bounce::study {
namespace {

constexpr int kStarts = 5;
// Whose parts the starts of a method without steps lie apart.
constexpr double kLargestStep = 0.01;  // s

// The scene as it is `time` later.
Scene later(const Scene& scene, double time) {
  if (time == 0) return scene;
  Scene until = scene, moved = scene;
  until.until = time;
  moved.start = state_of(truth_of(until, 1).front());
  return moved;
}

// A number of samples that divides the number of steps, or nearly so.
int samples_for(const Scene& scene, double dt) {
  const long steps = std::max(1L, std::lround(scene.until / dt));
  if (steps < kSamples) return int(steps);
  const auto off = [&](int samples) {
    return std::abs(steps - samples * std::lround(double(steps) / samples));
  };
  int samples = kSamples;
  for (int other = kSamples; other < 2 * kSamples; ++other)
    if (off(other) < off(samples)) samples = other;
  return samples;
}

// The starts of a scene for a step. dt divides scene.until into a whole number of steps, and the
// number of samples divides that number; dt is within 3 % of the step asked for, if that is at most
// scene.until / 40.
struct Starts {
  int samples;
  double dt;
  Scenes scenes;
  std::vector<Motions> truths;

  Starts(const Scene& scene, double asked)
      : samples(samples_for(scene, asked)), dt(fitting_step(scene, asked, samples)) {
    for (int i = 0; i < kStarts; ++i) {
      scenes.push_back(later(scene, dt * i / kStarts));
      truths.push_back(truth_of(scenes.back(), samples));
    }
  }
};

// A method at one setting, the step as it is run.
struct Point {
  const Method& method;
  double setting;
  int samples;
  double own_error = 0, mean_error = 0;  // m

  Point(const Method& used, double asked, const Starts& starts)
      : method(used), setting(used.has_step ? starts.dt : asked), samples(starts.samples) {
    double squares = 0;
    for (std::size_t i = 0; i < starts.scenes.size(); ++i) {
      const Scene& scene = starts.scenes[i];
      const auto moved = method.simulate(scene, setting, samples);
      const double error = error_of(scene, moved, starts.truths[i]);
      if (i == 0) own_error = error;
      squares += error * error;
    }
    mean_error = std::sqrt(squares / kStarts);
  }

  Job job(const Scene& scene) const {
    if (!method.time) return job_of([&] { method.simulate(scene, setting, samples); });
    return {[&](long repeats) { return method.time(scene, setting, repeats); }};
  }
};

}  // namespace

Table speed_accuracy(const Scenes& scenes, const Extent& extent) {
  Methods methods = all_methods();
  for (const auto& [name, peer] : all_peers)
    methods.push_back(method_of(name, peer, extent.is_quick ? 1e-3 : 1e-6));
  Table table({"scene", "method", "setting", "ns_per_simulated_second", "error_m", "own_error_m"});
  for (const Scene& scene : scenes) {
    std::map<double, Starts> starts;  // by step
    std::vector<Point> points;
    for (const Method& method : methods) {
      for (const double setting : method.settings) {
        const double step = method.has_step ? setting : kLargestStep;
        points.emplace_back(method, setting, starts.try_emplace(step, scene, step).first->second);
      }
    }
    std::vector<Job> jobs;
    jobs.reserve(points.size());
    for (const Point& point : points) jobs.push_back(point.job(scene));
    time_in_turn(jobs, extent);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Point& at = points[i];
      table.add(scene.name, at.method.name, at.setting, quantile(jobs[i].ns) / scene.until,
                at.mean_error, at.own_error);
    }
  }
  return table;
}

}  // namespace bounce::study
