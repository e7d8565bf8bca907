// Studies your program: how accurate, fast and stable it is. Writes a page with a verdict in plain
// numbers, a table of where methods fail, and charts; and prints the verdict, with a tab behind
// what each line is about.
//
//   study SCENES PAGE [--wrong]
//
// ./check starts it once all checks pass, or with --study. --wrong: some checks fail, and the page
// says so.
#include <algorithm>
#include <cmath>
#include <exception>
#include <iostream>

#include "measure.hpp"
#include "page.hpp"

namespace bounce::study {
namespace {

constexpr double kRounding = 1e-9;    // m
constexpr double kAboutAsLong = 1.2;  // two measurements of one program differ by as much
constexpr const char* kUnusable =
    "Your program returns NaN, or another number of columns, somewhere here: ./check says where.";

bool is_usable(const std::vector<Run>& runs) {
  return std::all_of(runs.begin(), runs.end(), [](const Run& r) { return std::isfinite(r.error); });
}

using Runs = std::vector<Run>::const_iterator;

Runs best(Runs begin, Runs end) {
  return std::min_element(begin, end, [](const Run& a, const Run& b) { return a.error < b.error; });
}

// The time of a step, and beside the course's program at about the same one, which the scene has in
// calls of solve_lcp.
std::string speed(const Scene& scene, const Run& run, double one_lcp) {
  if (!std::isfinite(run.error)) return kUnusable;
  const double course = scene.others[0]["reached"][0][0].get<double>() * one_lcp;
  return "In " + scene.title + ", with dt = " + number(run.dt) + " s, a step takes " +
         number(run.seconds * run.dt * 1e6, "%.2g") +
         " \xc2\xb5s in the mean of flight and contact: " + rounded(1 / run.seconds) +
         " times faster than real time. The course's program, measured elsewhere, is estimated to "
         "take " +
         number(course * run.dt * 1e6, "%.2g") + " \xc2\xb5s here.";
}

// The best that the program reaches, and from which run on a smaller step gains less than half of
// its error.
std::string accuracy(const Scene& scene, const std::vector<Run>& fixed) {
  if (!is_usable(fixed)) return kUnusable;
  const Runs mine = best(fixed.begin(), fixed.end());
  const auto gains = [&](const Run& run) {
    const Runs after = fixed.begin() + (&run - fixed.data()) + 1;
    return after != fixed.end() && best(after, fixed.end())->error <= run.error / 2;
  };
  const Runs stalls = std::find_if_not(fixed.begin(), fixed.end() - 1, gains);
  const std::string reaches = scene.title + ": " + length(mine->error) +
                              " off at best, with dt = " + number(mine->dt) + " s.";
  if (stalls + 1 == fixed.end()) return reaches + " Each smaller step helps.";
  return reaches + " Below dt = " + number(stalls->dt) + " s a smaller step " +
         (stalls->error <= mine->error ? "no longer helps"
                                       : "takes away less than half of the error") +
         ", while delta stays at " + length(scene.params.delta) + ".";
}

// What the other methods reach in the time of that best run.
std::string in_the_same_time(const Scene& scene, const std::vector<Run>& fixed, double one_lcp) {
  if (!is_usable(fixed)) return kUnusable;
  const double time = best(fixed.begin(), fixed.end())->seconds / one_lcp;
  std::string text = "In the time of your best run, and a fifth more,";
  for (const json& method : scene.others) {
    if (&method == &scene.others.front()) continue;  // the course's program
    double least = INFINITY;
    for (const json& reached : method["reached"]) {
      if (reached[0] <= kAboutAsLong * time) least = std::min<double>(least, reached[1]);
    }
    text += (&method == &scene.others.back() ? ", and the " : " the ") +
            std::string(method["name"]) +
            (std::isinf(least)   ? " takes longer"
             : least < kRounding ? " is right to rounding"
                                 : " reaches " + length(least));
  }
  return text + ". Both were measured elsewhere, in calls of solve_lcp, each of which takes " +
         number(one_lcp * 1e9) + " ns here. Moreau and Jean founded such time steps.";
}

// Error over time, beside other methods; and error over step.
json charts_of(const Scene& scene, const std::vector<Run>& fixed, const std::vector<Run>& scaled,
               double one_lcp) {
  json times, steps;
  for (const auto& [name, runs] :
       {std::pair("delta fixed", &fixed), {"delta = 0.1 m/s dt", &scaled}}) {
    Points over_time, over_step;
    for (const Run& r : *runs) {
      over_time.emplace_back(r.seconds * 1e6, r.error);
      over_step.emplace_back(r.dt, r.error);
    }
    times.push_back(line(std::string("yours, ") + name, over_time));
    steps.push_back(line(name, over_step));
  }
  for (const json& method : scene.others) {
    Points all;
    for (const json& reached : method["reached"])
      all.emplace_back(reached[0].get<double>() * one_lcp * 1e6, reached[1]);
    times.push_back(line(method["name"], all, "other"));
  }
  const auto chart = [&](const std::string& id, const std::string& title, const char* x,
                         const json& lines, const std::string& sentence) -> json {
    // What is 0 or below 1e-9 is drawn apart, below an axis that is logarithmic.
    return {{"id", id + "-" + scene.name},
            {"title", scene.title + ": " + title},
            {"x", {{"name", x}, {"log", true}}},
            {"y", {{"name", "error, m"}, {"log", true}}},
            {"lines", lines},
            {"sentence", sentence}};
  };
  return {chart("time", "Error over time", "time of a simulated second, \xc2\xb5s here", times,
                in_the_same_time(scene, fixed, one_lcp)),
          chart("step", "Error over step", "dt, s", steps, accuracy(scene, fixed))};
}

std::string model(const Scene& scene) {
  const auto [none, one, two] = touches(scene, 1e-3);
  const int all = none + one + two;
  if (all == 0) return kUnusable;
  return scene.title + ": in " + std::to_string(none) + " of " + std::to_string(all) +
         " steps of 1 ms nothing touches, and a formula is enough; " + std::to_string(one) +
         " need one corner, and " + (two ? std::to_string(two) : "none") + " a second one.";
}

// What the page draws.
json study(const std::vector<Scene>& scenes, bool is_wrong) {
  const double one_lcp = lcp_seconds();
  const Scene& first = scenes.front();
  json study{{"wrong", is_wrong}, {"trials", trials(first.params)}};
  // Of what the program is worth, the chart that shows it, and the question of Explore about it.
  const auto say = [&](const char* about, const std::string& text, const std::string& chart,
                       int question) {
    study["verdicts"].push_back(
        {{"about", about}, {"text", text}, {"chart", chart}, {"question", question}});
  };
  const std::string time = "time-" + first.name;
  for (const Scene& scene : scenes) {
    if (scene.truth.empty()) continue;
    const std::vector<Run> fixed = runs(scene, Lift::fixed), scaled = runs(scene, Lift::scaled);
    for (const json& chart : charts_of(scene, fixed, scaled, one_lcp))
      study["charts"].push_back(chart);
    if (&scene != &first) continue;
    say("speed", speed(scene, fixed[1], one_lcp), time, 7);  // with dt = 0.01 s
    say("accuracy", accuracy(scene, fixed), "step-" + scene.name, 1);
    say("", in_the_same_time(scene, fixed, one_lcp), time, 7);
  }
  const auto found = [&](int trial) { return std::string(study["trials"][trial]["found"]) + "."; };
  say("stability", "Large epsilon with friction: " + found(0), "impact", 3);
  say("", "Rest on a face: " + found(2), "rest", 4);
  say("model", model(first), time, 5);
  return study;
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
    const json made = study(read_scenes(argv[1]), argc > 3);
    bounce::check::write(argv[2], page_with("studied.html", made));
    for (const json& verdict : made["verdicts"]) {
      std::cout << std::string(verdict["about"]) << "\t" << std::string(verdict["text"])
                << " (question " << verdict["question"] << ")\n";
    }
  } catch (const std::exception& error) {
    std::cerr << "No study was written: " << error.what() << ".\n";
    return 1;
  }
  return 0;
}
