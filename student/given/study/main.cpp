// Studies your program: how wrong, how fast and how stable it is, over the size of the step. Writes
// a page with a chart for each, and a sentence below each chart.
//
//   study SCENES PAGE [--wrong]
//
// ./check --study builds and starts it. --wrong: some checks fail, and the page says so.
#include <cstdio>
#include <exception>
#include <iostream>
#include <string>

#include "chart.hpp"
#include "page.hpp"
#include "sentences.hpp"
#include "words.hpp"

namespace bounce::study {
namespace {

constexpr double kEnergySeconds = 1.5;
const std::string kMetres = std::string(kError) + ", m";
using Points = std::vector<std::pair<double, double>>;

template <class Of>
Points points(const std::vector<Run>& runs, const Of& of) {
  Points all;
  for (const Run& r : runs) all.push_back(of(r));
  return all;
}

std::string charts_of(const Scene& scene, const Both& runs) {
  const auto over_time = [](const Run& r) { return std::pair(r.lcp_calls, r.error); };
  const auto over_step = [](const Run& r) { return std::pair(r.dt, r.error); };
  std::vector<Line> times{
      {std::string(kYours) + ", delta fixed", points(runs.fixed, over_time), true},
      {std::string(kYours) + ", delta in proportion to dt", points(runs.scaled, over_time), true}};
  for (const Method& method : scene.others) {
    Points reached;
    for (const Reached& r : method.reached) reached.emplace_back(r.lcp_calls, r.error);
    times.push_back({method.name, reached, false});
  }
  const std::vector<Line> steps{
      {"delta fixed", points(runs.fixed, over_step), true},
      {"delta in proportion to dt", points(runs.scaled, over_step), true}};
  return "<h2>" + escaped(scene.title) + "</h2>\n<section>\n" +
         chart(kErrorOverTime, {std::string(kTime) + ", in calls of solve_lcp", kMetres, true},
               times, of_time(scene, runs)) +
         chart("Error over step", {"dt, s", kMetres, true}, steps, of_steps(scene, runs)) +
         "</section>\n";
}

Points curve(const Energy& energy) {
  Points all;
  for (std::size_t i = 0; i < energy.t.size(); ++i) all.emplace_back(energy.t[i], energy.share[i]);
  return all;
}

std::string stability(const Scene& scene, const std::vector<Run>& fixed) {
  const Energy coarse = energy(scene, 1e-2, kEnergySeconds),
               fine = energy(scene, 1e-3, kEnergySeconds);
  const Points depths = points(fixed, [](const Run& r) { return std::pair(r.dt, r.depth); });
  const Rest still = rest(scene.params, 1e-2, Lift::fixed);
  return "<h2>Stability</h2>\n<section>\n" +
         chart("Energy over time, " + scene.title, {"t, s", "energy, start = 1", false},
               {{"dt = 0.01 s", curve(coarse), true}, {"dt = 0.001 s", curve(fine), true}},
               of_energy(coarse, fine)) +
         chart("Deepest penetration, " + scene.title, {"dt, s", "below the ground, m", true},
               {{"delta fixed", depths, true}}, of_depth(fixed, scene.params.l)) +
         chart("At rest", {"", "", false}, {},
               of_rest(still, rest(scene.params, 1e-2, Lift::scaled),
                       rest(scene.params, 1e-3, Lift::scaled))) +
         "</section>\n";
}

std::string study(const std::vector<Scene>& scenes, bool is_wrong) {
  const double one_lcp = lcp_seconds();
  std::string body, last;
  for (const Scene& scene : scenes) {
    if (scene.truth.empty()) continue;
    std::cout << "  " << scene.title << std::endl;
    const Both both{runs(scene, Lift::fixed, one_lcp), runs(scene, Lift::scaled, one_lcp)};
    body += charts_of(scene, both);
    if (&scene == &scenes.front()) last = stability(scene, both.fixed);
  }
  body += last;
  char cost[80];
  std::snprintf(cost, sizeof cost, "%.0f ns here", one_lcp * 1e9);
  return page(
      "Your program: speed, accuracy, stability",
      is_wrong ? "Some checks fail. The charts show your program as it is; mend what ./check "
                 "names first, then study it."
               : "",
      "<p>Each dot of your lines is a run of your four parts with another dt. The truth is an "
      "exact simulation of the same model; the error is the largest distance to it at twenty "
      "moments. Left and below is better. Computing times are in calls of the given solve_lcp (" +
          std::string(cost) +
          "), so that the lines of the other methods, measured elsewhere, hold on your "
          "machine. The Moreau–Jean scheme has the same laws, looks for contact half a step "
          "ahead, and lets both corners of a side push.</p>\n" +
          body + "<p>Questions to these charts: <a href=\"explore.html\">Explore</a>.</p>\n");
}

}  // namespace
}  // namespace bounce::study

int main(int argc, char** argv) {
  if (argc < 3) {
    std::cerr << "usage: study SCENES PAGE [--wrong]; ./check --study starts it\n";
    return 2;
  }
  try {
    const auto scenes = bounce::study::read_scenes(argv[1]);
    bounce::study::write_page(argv[2], bounce::study::study(scenes, argc > 3));
  } catch (const std::exception& error) {
    std::cerr << "No study was written: " << error.what() << ".\n";
    return 1;
  }
  return 0;
}
