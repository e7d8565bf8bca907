#include "advice.hpp"

#include <algorithm>

#include "catalog.hpp"
#include "ladder.hpp"
#include "timing.hpp"

namespace bounce::study {
namespace {

constexpr long kMostEvents = 20'000;  // of a model

std::vector<ModelRun> model_runs(const Scene& scene, const Answer& answer, double tolerance) {
  EventOptions options;
  options.most_events = kMostEvents;
  std::vector<ModelRun> runs;
  bool found = false;
  for (int i = 0; i < kModelLevels; ++i) {
    const ModelLevel level = ModelLevel(i);
    const bool whole = level == ModelLevel::two_frictions;
    const Samples motions =
        whole ? answer.motions : motion_with(scene, level, answer.times, options);
    const double error = error_of(scene, motions, answer.motions) + answer.bound;
    const bool least = !found && error <= tolerance;
    found = found || least;
    runs.push_back({level, error, least});
  }
  return runs;
}

// From the coarsest, of a method that is asked for this many samples.
std::vector<double> settings_of(const Method& method, const Scene& scene, int samples) {
  if (!method.has_step) return method.settings;
  std::vector<double> steps;
  for (long n = 1; n * samples <= kMostSteps; n *= 2) {
    steps.push_back(scene.until / samples / double(n));
  }
  return steps;
}

}  // namespace

Advice advise(const Scene& scene, const Answer& answer, double tolerance) {
  Scene compared = scene;
  compared.until = answer.times.back();
  const int samples = int(answer.times.size()) - 1;
  Advice advice{model_runs(compared, answer, tolerance), {}};
  if (samples == 0) return advice;
  const Samples truth(answer.motions.begin() + 1, answer.motions.end());
  std::vector<Job> jobs;
  for (const Method& method : all_methods()) {
    bool coarser_is = false;
    for (const double setting : settings_of(method, compared, samples)) {
      const auto run = [=, &compared] { return method.simulate(compared, setting, samples); };
      const double error = error_of(compared, run(), truth) + answer.bound;
      const bool is = error <= tolerance;
      if (coarser_is) advice.methods.back().within = is;
      advice.methods.push_back({method.name, method.has_step, setting, error, 0, false});
      jobs.push_back(job_of([run] { run(); }));
      if (coarser_is && is) break;
      coarser_is = is;
    }
  }
  time_in_turn(jobs, kQuick);
  for (std::size_t i = 0; i < jobs.size(); ++i)
    advice.methods[i].ns = *std::min_element(jobs[i].ns.begin(), jobs[i].ns.end());
  return advice;
}

}  // namespace bounce::study
