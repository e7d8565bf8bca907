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
#include <numeric>

#include "measure.hpp"
#include "page.hpp"

namespace bounce::study {
namespace {

constexpr double kRounding = 1e-9;             // m
constexpr double kAboutAsLong = 1.2;           // two measurements of one program differ by as much
constexpr std::size_t kUsual = 1, kTenth = 4;  // the runs with dt = 0.01 s and with a tenth of it
constexpr double kFinest = 9e-5;  // s: the causes are told apart of steps that are longer
constexpr const char* kUnusable =
    "Your program returns NaN, or another number of columns, somewhere here: ./check says where.";

// A scene, the runs of it, and the causes of the error of the first ones with a fixed delta.
struct Measured {
  const Scene& scene;
  double one_lcp;
  std::vector<Run> fixed = runs(scene, Lift::fixed), scaled = runs(scene, Lift::scaled);
  std::vector<std::array<double, 4>> causes{};
};

bool less(const Run& a, const Run& b) { return a.error < b.error; }
const Run& best(const std::vector<Run>& runs) {
  return *std::min_element(runs.begin(), runs.end(), less);
}
bool is_usable(const std::vector<Run>& runs) {
  return std::isfinite(std::max_element(runs.begin(), runs.end(), less)->error);
}

std::string with_step(const Run& run) { return "with dt = " + number(run.dt) + " s"; }
std::string percent(double share) { return number(share, "%.0f") + " %"; }

// The time of a step, and beside the course's program at about the same one, which the scene has in
// calls of solve_lcp.
std::string speed(const Measured& of) {
  const Run& run = of.fixed[kUsual];
  const double course = of.scene.others[0]["reached"][0][0].get<double>() * of.one_lcp;
  return "In " + of.scene.title + ", " + with_step(run) + ", a step takes " +
         number(run.seconds * run.dt * 1e6, "%.2g") +
         " \xc2\xb5s in the mean of flight and contact: " + rounded(1 / run.seconds) +
         " times faster than real time. The course's program would take about " +
         number(course * run.dt * 1e6, "%.2g") + " \xc2\xb5s here.";
}

// What each cause makes alone, of the sum of these, %.
std::array<double, 4> shares(std::array<double, 4> causes) {
  const double sum = std::max(kRounding, std::accumulate(causes.begin(), causes.end(), 0.0));
  for (double& cause : causes) cause *= 100 / sum;
  return causes;
}

template <class Numbers>
std::size_t largest(const Numbers& all) {
  return static_cast<std::size_t>(std::max_element(all.begin(), all.end()) - all.begin());
}

// The causes with the usual step, and what a tenth does of what the largest one shrinks with.
std::string error(const Measured& of) {
  const Run& run = of.fixed[kUsual];
  const auto all = shares(of.causes[kUsual]);
  std::string text = of.scene.title + ", " + with_step(run) + ": " + length(run.error) + " off.";
  for (std::size_t i = 0; i < all.size(); ++i)
    text += (i ? ", " : " Alone, ") + std::string(kCauses[i]) + (i ? " " : " makes ") +
            length(of.causes[kUsual][i]) + " (" + percent(all[i]) + ")";
  text += "; the shares are of their sum. Next, for the largest: ";
  if (largest(all) == 3) return text + "mend what ./check names first.";
  const bool is_of_step = largest(all) < 2;
  return text + "a tenth of dt " + (is_of_step ? "" : "and of delta ") + "makes it " +
         length((is_of_step ? of.fixed : of.scaled)[kTenth].error) + ".";
}

// The best that the program reaches, what keeps it from more, and what helps.
std::string accuracy(const Measured& of) {
  const Run &mine = best(of.fixed), &other = best(of.scaled);
  const Run& fine = of.fixed[of.causes.size() - 1];
  const auto all = shares(of.causes.back());
  std::string text =
      of.scene.title + ": " + length(mine.error) + " off at best, " + with_step(mine) + ".";
  if (fine.dt < mine.dt)
    text += " A smaller step does not help: " + with_step(fine) + " it is " + length(fine.error) +
            ", " + percent(all[largest(all)]) + " by " + kCauses[largest(all)] + ".";
  if (other.error < mine.error / 2)
    text += " Next: shrink delta with dt; delta = 0.1 m/s dt makes it " + length(other.error) +
            ", " + with_step(other) + ".";
  return text;
}

// What the other methods reach in the time of that best run.
std::string in_the_same_time(const Measured& of) {
  const Run& mine = best(of.fixed);
  std::string text = "Given " + number(kAboutAsLong) + " times the time of your best run,";
  for (const json& method : of.scene.others) {
    if (&method == &of.scene.others.front()) continue;  // the course's program
    double least = INFINITY;
    for (const json& reached : method["reached"]) {
      if (reached[0] <= kAboutAsLong * mine.seconds / of.one_lcp)
        least = std::min<double>(least, reached[1]);
    }
    text += (&method == &of.scene.others.back() ? ", and the " : " the ") +
            std::string(method["name"]) +
            (std::isinf(least)   ? " takes longer"
             : least < kRounding ? " is right to rounding"
                                 : " reaches " + length(least)) +
            (least > mine.error && !std::isinf(least) ? ", worse than yours" : "");
  }
  return text + ". Times of the others are scaled to this machine by the time of one solve_lcp, " +
         number(of.one_lcp * 1e9) + " ns.";
}

// Error over time, beside other methods; and error over step, beside what makes it.
json charts_of(const Measured& of, const std::string& reached, const std::string& best) {
  json times, steps;
  for (const auto& [name, runs] :
       {std::pair("delta fixed", &of.fixed), {"delta = 0.1 m/s dt", &of.scaled}}) {
    Points over_time, over_step;
    for (const Run& r : *runs) {
      over_time.emplace_back(r.seconds * 1e6, r.error);
      over_step.emplace_back(r.dt, r.error);
    }
    times.push_back(line(std::string("yours, ") + name, over_time));
    steps.push_back(line(name, over_step));
  }
  for (const json& method : of.scene.others) {
    Points all;
    for (const json& reached : method["reached"])
      all.emplace_back(reached[0].get<double>() * of.one_lcp * 1e6, reached[1]);
    times.push_back(line(method["name"], all, "other"));
  }
  for (std::size_t i = 0; i < 3; ++i) {
    Points all;
    for (std::size_t k = 0; k < of.causes.size(); ++k)
      all.emplace_back(of.fixed[k].dt, of.causes[k][i]);
    steps.push_back(line(std::string(kCauses[i]) + " alone", all, "other"));
  }
  const auto chart = [&](const std::string& id, const std::string& title, const char* x,
                         const json& lines, const std::string& sentence) -> json {
    // What is 0 or below 1e-9 is drawn apart, below an axis that is logarithmic.
    return {{"id", id + "-" + of.scene.name},
            {"title", of.scene.title + ": " + title},
            {"x", {{"name", x}, {"log", true}}},
            {"y", {{"name", "error, m"}, {"log", true}}},
            {"lines", lines},
            {"sentence", sentence}};
  };
  return {chart("time", "Error over time", "time of a simulated second, \xc2\xb5s here", times,
                reached),
          chart("step", "Error over step", "dt, s", steps, best)};
}

// A column of the table of causes: of each its error, and its share in %; and the error of all.
json column_of(const Measured& of) {
  json cells(5, nullptr);
  for (std::size_t i = 0; i < 4; ++i) {
    const double share = shares(of.causes[kUsual])[i];
    cells[i] = {length(of.causes[kUsual][i]) + ", " + percent(share), share};
  }
  cells[4] = {length(of.fixed[kUsual].error), 0};
  return {{"title", of.scene.title}, {"cells", cells}};
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
  json study{{"wrong", is_wrong}, {"causes", json::array()}, {"trials", trials(first.params)}};
  // Of what the program is worth, the chart that shows it, and the question of Explore about it.
  const auto say = [&](const char* about, const std::string& text, const std::string& chart,
                       int question) {
    study["verdicts"].push_back(
        {{"about", about}, {"text", text}, {"chart", chart}, {"question", question}});
  };
  const std::string time = "time-" + first.name;
  for (const Scene& scene : scenes) {
    if (scene.truth.empty()) continue;
    Measured of{scene, one_lcp};
    const bool usable = is_usable(of.fixed) && is_usable(of.scaled);
    for (const Run& run : of.fixed)
      if (usable && run.dt >= kFinest) of.causes.push_back(causes(scene, run.dt));
    const auto told = [&](std::string (*sentence)(const Measured&)) {
      return usable ? sentence(of) : kUnusable;
    };
    for (const json& chart : charts_of(of, told(in_the_same_time), told(accuracy)))
      study["charts"].push_back(chart);
    if (usable) study["causes"].push_back(column_of(of));
    if (&scene != &first) continue;
    say("speed", told(speed), time, 7);
    say("accuracy", told(error), "causes", 1);
    say("", told(accuracy), "step-" + scene.name, 1);
    say("", told(in_the_same_time), time, 7);
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
