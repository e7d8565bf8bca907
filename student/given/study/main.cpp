// Studies your program: how wrong, how fast and how stable it is, over the size of the step. Writes
// a page with a chart for each, and a sentence below each chart.
//
//   study SCENES PAGE [--wrong]
//
// ./check --study builds and starts it. --wrong: some checks fail, and the page says so.
#include <cstdio>
#include <exception>
#include <fstream>
#include <iostream>
#include <string>

#include "chart.hpp"
#include "sentences.hpp"

namespace bounce::study {
namespace {

constexpr double kEnergySeconds = 1.5;
const char* const kStyle = R"css(
:root { color-scheme: light dark; --ink: #1f2430; --paper: #ffffff; --soft: #646a73; --grid: #e3e5e8;
  --a: #0067a3; --b: #b34700; --c: #00704f; --d: #98396f; --e: #5b5f66; }
@media (prefers-color-scheme: dark) { :root { --ink: #e8e6e1; --paper: #14181f; --soft: #a4a9b1;
  --grid: #2c323b; --a: #56b4e9; --b: #f0a040; --c: #2fc79b; --d: #e79ac8; --e: #b0b5bd; } }
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 1rem 1.2rem 4rem; max-width: 92rem; color: var(--ink);
  background: var(--paper); font: 1rem/1.55 system-ui, sans-serif; }
p, .wrong { max-width: 46rem; }
.wrong { border-left: 4px solid var(--b); padding-left: 0.8rem; }
section { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 30rem), 1fr));
  gap: 1rem 2.5rem; }
figure { margin: 0; }
h3 { margin: 0.8rem 0 0.3rem; font-size: 1.05rem; }
figure > svg { width: 100%; height: auto; }
text { fill: var(--ink); font: 13px system-ui, sans-serif; }
.grid { stroke: var(--grid); fill: none; }
.line { fill: none; stroke-width: 1.8; stroke-dasharray: 6 4; }
.dots { fill: none; stroke-width: 6; stroke-linecap: round; }
.own { stroke-dasharray: none; stroke-width: 2.6; }
.dots.own { stroke-width: 7; }
.k0 { stroke: var(--a); } .k1 { stroke: var(--b); } .k2 { stroke: var(--c); }
.k3 { stroke: var(--d); } .k4 { stroke: var(--e); }
ul { display: flex; flex-wrap: wrap; gap: 0 1.2rem; margin: 0.2rem 0; padding: 0; list-style: none;
  font-size: 0.9rem; }
figcaption { margin: 0.3rem 0 0.8rem; }
@media (max-width: 640px) { text { font-size: 18px; } }
@media print { :root { --ink: #000; --paper: #fff; } body { font-size: 10pt; }
  figure { break-inside: avoid; } }
)css";

using Points = std::vector<std::pair<double, double>>;

template <class Of>
Points points(const std::vector<Run>& runs, const Of& of) {
  Points all;
  for (const Run& r : runs) all.push_back(of(r));
  return all;
}

std::string charts_of(const Scene& scene, const Both& runs) {
  const auto over_time = [](const Run& r) { return std::pair(r.kernels, r.error); };
  const auto over_step = [](const Run& r) { return std::pair(r.dt, r.error); };
  std::vector<Line> times{
      {"yours, delta fixed", points(runs.fixed, over_time), true},
      {"yours, delta in proportion to dt", points(runs.scaled, over_time), true}};
  for (const Method& method : scene.others) {
    Points reached;
    for (const Reached& r : method.reached) reached.emplace_back(r.kernels, r.error);
    times.push_back({method.name, reached, false});
  }
  const std::vector<Line> steps{
      {"delta fixed", points(runs.fixed, over_step), true},
      {"delta in proportion to dt", points(runs.scaled, over_step), true}};
  return "<h2>" + escaped(scene.title) + "</h2>\n<section>\n" +
         chart("Error over time", {"time of a simulated second, solve_lcp = 1", "error, m", true},
               times, of_time(scene, runs)) +
         chart("Error over step", {"dt, s", "error, m", true}, steps, of_steps(scene, runs)) +
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

std::string page(const std::vector<Scene>& scenes, bool is_wrong) {
  const double kernel = kernel_seconds();
  std::string body, last;
  for (const Scene& scene : scenes) {
    if (scene.truth.empty()) continue;
    std::cout << "  " << scene.title << std::endl;
    const Both both{runs(scene, Lift::fixed, kernel), runs(scene, Lift::scaled, kernel)};
    body += charts_of(scene, both);
    if (&scene == &scenes.front()) last = stability(scene, both.fixed);
  }
  body += last;
  char cost[80];
  std::snprintf(cost, sizeof cost, "%.0f ns here", kernel * 1e9);
  return std::string("<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n") +
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n" +
         "<title>Your program: speed, accuracy, stability</title>\n<style>" + kStyle +
         "</style>\n</head>\n<body>\n<main>\n<h1>Your program: speed, accuracy, stability</h1>\n" +
         (is_wrong ? "<p class=\"wrong\">Some checks fail. The charts show your program as it is; "
                     "mend what ./check names first, then study it.</p>\n"
                   : "") +
         "<p>Each dot is a run of your four parts with another dt. The truth is an exact "
         "simulation "
         "of the same model; the error is the largest distance to it at twenty times. Left and "
         "below is better. Times are in calls of the given solve_lcp (" +
         cost + "), so that the dashed lines, measured elsewhere, hold on your machine.</p>\n" +
         body + "<p>Questions to these charts: <a href=\"explore.html\">Explore</a>.</p>\n" +
         "</main>\n</body>\n</html>\n";
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
    const std::string html = bounce::study::page(scenes, argc > 3);
    if (!(std::ofstream(argv[2], std::ios::binary) << html).flush()) {
      throw std::runtime_error(std::string(argv[2]) + " can't be written");
    }
  } catch (const std::exception& error) {
    std::cerr << "No study was written: " << error.what() << ".\n";
    return 1;
  }
  return 0;
}
