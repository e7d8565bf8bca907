// Studies your program: how accurate, fast and stable it is. Writes a page with a verdict in plain
// numbers, a table of where methods fail, and charts; and prints the verdict, with a tab behind
// what each line is about.
//
//   study SCENES PAGE [--wrong]
//
// ./check starts it once all checks pass, or with --study. --wrong: some checks fail, and the page
// says so.
#include <cmath>
#include <exception>
#include <iostream>

#include "accuracy.hpp"
#include "numbers.hpp"
#include "pages.hpp"
#include "stability.hpp"

namespace bounce::study {
namespace {

// One of what the program is worth, the chart that shows it, and the question of Explore about it.
struct Verdict {
  std::string about, text, chart;
  int question;
};

struct Study {
  std::vector<Verdict> verdicts;
  std::vector<Trial> trials;
  std::vector<Chart> charts;
};

// The time of a step, and beside the course's program at about the same one, which the scene has in
// calls of solve_lcp.
std::string speed(const Scene& scene, const Run& run, double one_lcp) {
  if (!std::isfinite(run.error)) return "There is no whole motion to time: ./check says why.";
  const double course = scene.others.front().reached.front().lcp_calls * one_lcp;
  return "A step takes " + number(run.seconds * run.dt * 1e6, "%.2g") +
         " \xc2\xb5s. With dt = " + number(run.dt) + " s that is " + rounded(1 / run.seconds) +
         " times faster than real time. The course's program takes " +
         number(course / run.seconds, "%.2g") + " times as long as yours.";
}

std::string model(const Scene& scene) {
  const Touches touched = touches(scene, 1e-3);
  const int all = touched.none + touched.one + touched.two;
  if (all == 0) return "No motion to look at: ./check says why.";
  return scene.title + ": in " + std::to_string(touched.none) + " of " + std::to_string(all) +
         " steps of 1 ms nothing touches, and a formula is enough; " + std::to_string(touched.one) +
         " need one corner, and " + std::to_string(touched.two) + " a second one.";
}

Study study(const std::vector<Scene>& scenes) {
  const double one_lcp = lcp_seconds();
  const Scene& first = scenes.front();
  Study study;
  study.trials = trials(first.params);
  for (const Scene& scene : scenes) {
    if (scene.truth.empty()) continue;
    const Both both{runs(scene, Lift::fixed), runs(scene, Lift::scaled)};
    for (Chart& chart : charts_of(scene, both, one_lcp)) study.charts.push_back(std::move(chart));
    if (&scene != &first) continue;
    const Run& usual = both.fixed[1];  // dt = 0.01 s
    study.verdicts = {{"speed", speed(scene, usual, one_lcp), "time-" + scene.name, 7},
                      {"accuracy", accuracy(scene, both.fixed), "step-" + scene.name, 1},
                      {"", in_the_same_time(scene, both.fixed, one_lcp), "time-" + scene.name, 7}};
  }
  const auto of_trial = [&](std::size_t i, const std::string& about, int question) {
    const Trial& trial = study.trials[i];
    study.verdicts.push_back(
        {about, trial.chart.title + ": " + trial.found + ".", trial.chart.id, question});
  };
  of_trial(0, "stability", 3);
  of_trial(2, "", 4);
  study.verdicts.push_back({"model", model(first), "time-" + first.name, 5});
  return study;
}

std::string json(const Verdict& verdict) {
  return R"({"about":)" + quoted(verdict.about) + R"(,"text":)" + quoted(verdict.text) +
         R"(,"chart":)" + quoted(verdict.chart) + R"(,"question":)" +
         std::to_string(verdict.question) + "}";
}

std::string json(const Study& study, bool is_wrong) {
  const auto of_verdict = [](const Verdict& verdict) { return json(verdict); };
  const auto of_chart = [](const Chart& chart) { return json(chart); };
  const auto of_trial = [](const Trial& trial) {
    return R"({"due":)" + quoted(trial.due) + R"(,"found":)" + quoted(trial.found) +
           R"(,"chart":)" + json(trial.chart) + "}";
  };
  return R"({"wrong":)" + std::string(is_wrong ? "true" : "false") +
         ",\n\"verdicts\":" + list(study.verdicts, of_verdict) +
         ",\n\"trials\":" + list(study.trials, of_trial) +
         ",\n\"charts\":" + list(study.charts, of_chart) + "}";
}

}  // namespace
}  // namespace bounce::study

int main(int argc, char** argv) {
  using namespace bounce::study;
  if (argc < 3) {
    std::cerr << "usage: study SCENES PAGE [--wrong]; ./check --study starts it\n";
    return 2;
  }
  try {
    const Study made = study(read_scenes(argv[1]));
    write_page(argv[2], bounce::pages::studied, json(made, argc > 3));
    for (const Verdict& verdict : made.verdicts) {
      std::cout << verdict.about << "\t" << verdict.text << " (question " << verdict.question
                << ")\n";
    }
  } catch (const std::exception& error) {
    std::cerr << "No study was written: " << error.what() << ".\n";
    return 1;
  }
  return 0;
}
