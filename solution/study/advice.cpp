#include "advice.hpp"

#include <algorithm>

#include "catalog.hpp"
#include "ladder.hpp"
#include "timing.hpp"

namespace bounce::study {
namespace {

using json = nlohmann::ordered_json;

constexpr long kMostEvents = 20'000;  // of a model

json model_runs(const Scene& scene, const Answer& answer, double tolerance) {
  json runs = json::array();
  bool found = false;
  for (int i = 0; i < kModelLevels; ++i) {
    const ModelLevel level = ModelLevel(i);
    const bool whole = level == ModelLevel::two_frictions;
    const Samples motions =
        whole ? answer.motions
              : motion_with(scene, level, answer.times, {.most_events = kMostEvents});
    const double error = error_of(scene, motions, answer.motions) + answer.bound;
    const bool least = !found && error <= tolerance;
    found = found || least;
    runs.push_back({{"model", name_of(level)}, {"error", error}, {"least", least}});
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

json advise(const Scene& scene, const Answer& answer, double tolerance) {
  Scene compared = scene;
  compared.until = answer.times.back();
  const int samples = int(answer.times.size()) - 1;
  json advice{{"models", model_runs(compared, answer, tolerance)}, {"methods", json::array()}};
  json& runs = advice["methods"];
  const Samples truth(answer.motions.begin() + 1, answer.motions.end());
  std::vector<Job> jobs;
  for (const Method& method : samples > 0 ? all_methods() : Methods()) {
    bool coarser_is = false;
    for (const double setting : settings_of(method, compared, samples)) {
      const auto run = [=, &compared] { return method.simulate(compared, setting, samples); };
      const double error = error_of(compared, run(), truth) + answer.bound;
      const bool is = error <= tolerance;
      if (coarser_is) runs.back()["within"] = is;
      runs.push_back({{"method", method.name},
                      {method.has_step ? "step" : "tolerance", setting},
                      {"error", error},
                      {"ns", 0},
                      {"within", false}});
      jobs.push_back(job_of([run] { run(); }));
      if (coarser_is && is) break;
      coarser_is = is;
    }
  }
  time_in_turn(jobs, kQuick);
  for (std::size_t i = 0; i < jobs.size(); ++i)
    runs[i]["ns"] = *std::min_element(jobs[i].ns.begin(), jobs[i].ns.end());
  return advice;
}

}  // namespace bounce::study
