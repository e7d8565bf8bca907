#include <algorithm>
#include <cmath>
#include <limits>

#include "catalog.hpp"
#include "event_driven.hpp"
#include "questions.hpp"
#include "simulate_scene.hpp"
#include "timing.hpp"

namespace bounce::study {
namespace {

constexpr double kFine = 1e-3;  // m

// The scene with no more than this model, its times of impact exact.
Samples run_model(const Scene& scene, Rung rung) {
  const auto start = methods::motion_of<double>(scene.start);
  if (rung == Rung::asleep) return Samples(kSamples, start);
  EventOptions options;
  options.model.corners = rung == Rung::ballistic                                  ? 0
                          : rung == Rung::one_normal || rung == Rung::one_friction ? 1
                                                                                   : 2;
  options.model.friction = rung == Rung::one_friction || rung == Rung::two_frictions;
  return simulate_events<double>(scene.params, start, sample_times(scene), options);
}

}  // namespace

Table least_model(const Scenes& scenes, const Extent& extent) {
  Table table({"scene", "model", "error_m", "ns_per_simulated_second", "least", "expected"});
  for (const Scene& scene : scenes) {
    const Samples truth = truth_of(scene);
    std::vector<Job> jobs;
    jobs.reserve(kRungs);
    for (int i = 0; i < kRungs; ++i) jobs.push_back({[&scene, i] { run_model(scene, Rung(i)); }});
    time_in_turn(jobs, extent);
    bool found = false;
    for (int i = 0; i < kRungs; ++i) {
      const Rung rung = Rung(i);
      const double error = error_of(scene, run_model(scene, rung), truth);
      const bool least = !found && error <= kFine;
      found = found || least;
      table.add(scene.name, name_of(rung), error, quantile(jobs[std::size_t(i)].ns) / scene.until,
                least, rung == scene.least);
    }
  }
  return table;
}

Table chosen_model(const Scenes& scenes, const Extent& extent) {
  Table table({"scene", "dt_s", "model", "steps", "seconds", "distance_to_whole_m", "times_as_fast",
               "warnings"});
  for (const Scene& scene : scenes) {
    for (const double dt : {1e-2, 1e-3, 1e-4}) {
      Parameters params = scene.params;
      params.dt = dt;
      params.T = int(std::lround(scene.until / dt)) + 1;
      ModelReport report;
      const Trajectory chosen = simulate_scene(params, scene.start, &report);
      const Trajectory whole = simulate_whole(params, scene.start);
      std::vector<Job> jobs{{[&] { simulate_scene(params, scene.start); }},
                            {[&] { simulate_whole(params, scene.start); }}};
      time_in_turn(jobs, extent);
      const double times_as_fast = quantile(ratios(jobs[1], jobs[0]));
      std::string warnings;
      for (const std::string& text : report.warnings)
        warnings += (warnings.empty() ? "" : "; ") + text;
      const double apart = (chosen.q - whole.q).cwiseAbs().maxCoeff();
      for (int i = 0; i < kRungs; ++i) {
        table.add(scene.name, dt, name_of(Rung(i)), report.steps[std::size_t(i)],
                  report.seconds[std::size_t(i)], apart, times_as_fast, warnings);
      }
    }
  }
  return table;
}

}  // namespace bounce::study
