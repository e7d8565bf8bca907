#include "simulate.hpp"

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "../exact/simulate_to.hpp"
#include "catalog.hpp"
#include "timing.hpp"

namespace bounce::study {
namespace {

using json = nlohmann::ordered_json;

constexpr long kMostSteps = 250'000;
constexpr long kMostEvents = 20'000;  // of a model

json model_runs(const Scene& scene, const Answer& answer, double tolerance) {
  json runs = json::array();
  bool found = false;
  for (int i = 0; i < kModelLevels; ++i) {
    const ModelLevel level = ModelLevel(i);
    const bool whole = level == ModelLevel::two_frictions;
    const Motions motions =
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

double number_of(const std::string& text) {
  double x = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), x);
  if (error != std::errc() || end != text.data() + text.size()) {
    throw std::invalid_argument("the tolerance is \"" + text +
                                "\"; it must be a number, in metres");
  }
  return x;
}

json json_of(const Answer& answer, double seconds) {
  json q = json::array(), v = json::array();
  for (const auto& s : answer.motions) {
    q.push_back({s.x, s.y, s.theta});
    v.push_back({s.v_x, s.v_y, s.omega});
  }
  return {{"times", answer.times},
          {"q", q},
          {"v", v},
          {"method", answer.method},
          {"bound", answer.bound},
          {"horizon", answer.times.back()},
          {"seconds", seconds}};
}

json advise(const Scene& scene, const Answer& answer, double tolerance) {
  Scene compared = scene;
  compared.until = answer.times.back();
  const int samples = int(answer.times.size()) - 1;
  json advice{{"models", model_runs(compared, answer, tolerance)}, {"methods", json::array()}};
  json& runs = advice["methods"];
  const Motions truth(answer.motions.begin() + 1, answer.motions.end());
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

}  // namespace

void simulate(const std::filesystem::path& file, const std::string& tolerance, std::ostream& out) {
  const Scene scene = read_scene(file, false);
  const double within = number_of(tolerance), begin = cpu_ns();
  const Answer answer = simulate_to(scene, within);
  json whole = json_of(answer, (cpu_ns() - begin) / 1e9);
  whole.update(advise(scene, answer, within));
  EventReport report;
  simulate_events<double>(scene.params, motion_of(scene.start), answer.times, {}, &report);
  whole["impacts"] = report.impacts;
  whole["doubts"] = doubts(scene);
  out << whole << "\n";
}

}  // namespace bounce::study
