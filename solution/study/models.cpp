#include <malloc.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "../exact/event_driven.hpp"
#include "../exact/simulate_scene.hpp"
#include "catalog.hpp"
#include "questions.hpp"
#include "timing.hpp"

namespace bounce::study {
namespace {

constexpr double kFine = 1e-3;  // m

// Simulates the scene with at most this model, with exact times of impact.
Samples run_model(const Scene& scene, ModelLevel level) {
  const auto start = methods::motion_of<double>(scene.start);
  if (level == ModelLevel::asleep) return Samples(kSamples, start);
  EventOptions options;
  options.model.corners = level == ModelLevel::ballistic ? 0
                          : level == ModelLevel::one_normal || level == ModelLevel::one_friction
                              ? 1
                              : 2;
  options.model.friction = level == ModelLevel::one_friction || level == ModelLevel::two_frictions;
  return simulate_events<double>(scene.params, start, sample_times(scene), options);
}

// Keeps freed memory in this process, so that no time includes the system's allocation of pages,
// which takes longer than a flight.
void keep_memory() {
  mallopt(M_MMAP_THRESHOLD, 1 << 28);
  mallopt(M_TRIM_THRESHOLD, 1 << 29);
}

// How many times as fast simulate_scene is as its scheme with the whole model in every step, and as
// the plain scheme.
struct Gain {
  double whole, moreau_jean;
};

Gain gain_of(const Parameters& params, const State& start, const Extent& extent) {
  std::vector<Job> jobs{{[&] { simulate_scene(params, start); }},
                        {[&] { simulate_whole(params, start); }},
                        {[&] { simulate_moreau_jean(params, start); }}};
  time_in_turn(jobs, extent);
  return {quantile(ratios(jobs[1], jobs[0])), quantile(ratios(jobs[2], jobs[0]))};
}

std::string joined(const std::vector<std::string>& texts) {
  std::string all;
  for (const std::string& text : texts) all += (all.empty() ? "" : "; ") + text;
  return all;
}

}  // namespace

Table least_model(const Scenes& scenes, const Extent& extent) {
  Table table({"scene", "model", "error_m", "ns_per_simulated_second", "least", "expected"});
  for (const Scene& scene : scenes) {
    const Samples truth = truth_of(scene);
    std::vector<Job> jobs;
    jobs.reserve(kModelLevels);
    for (int i = 0; i < kModelLevels; ++i)
      jobs.push_back({[&scene, i] { run_model(scene, ModelLevel(i)); }});
    time_in_turn(jobs, extent);
    bool found = false;
    for (int i = 0; i < kModelLevels; ++i) {
      const ModelLevel level = ModelLevel(i);
      const double error = error_of(scene, run_model(scene, level), truth);
      const bool least = !found && error <= kFine;
      found = found || least;
      table.add(scene.name, name_of(level), error, quantile(jobs[std::size_t(i)].ns) / scene.until,
                least, level == scene.least);
    }
  }
  return table;
}

Table chosen_model(const Scenes& scenes, const Extent& extent) {
  Table table({"scene", "dt_s", "model", "steps", "seconds", "distance_to_whole_m",
               "times_as_fast_as_whole", "times_as_fast_as_moreau_jean", "warnings"});
  keep_memory();
  for (const Scene& scene : scenes) {
    for (const double dt : {1e-2, 1e-3, 1e-4}) {
      Parameters params = scene.params;
      params.dt = dt;
      params.T = int(std::lround(scene.until / dt)) + 1;
      ModelReport report;
      const Trajectory chosen = simulate_scene(params, scene.start, &report);
      const Trajectory whole = simulate_whole(params, scene.start);
      const double apart = (chosen.q - whole.q).cwiseAbs().maxCoeff();
      const Gain gain = gain_of(params, scene.start, extent);
      for (int i = 0; i < kModelLevels; ++i) {
        table.add(scene.name, dt, name_of(ModelLevel(i)), report.steps[std::size_t(i)],
                  report.seconds[std::size_t(i)], apart, gain.whole, gain.moreau_jean,
                  joined(report.warnings));
      }
    }
  }
  return table;
}

}  // namespace bounce::study
