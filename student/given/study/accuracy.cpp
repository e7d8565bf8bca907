#include "accuracy.hpp"

#include <algorithm>
#include <cmath>

#include "numbers.hpp"

namespace bounce::study {
namespace {

constexpr double kRounding = 1e-9;    // m
constexpr double kAboutAsLong = 1.2;  // two measurements of one program differ by as much
constexpr const char* kUnusable =
    "Your program returns NaN, or another number of columns, somewhere here: ./check says where.";

bool is_usable(const std::vector<Run>& runs) {
  return std::all_of(runs.begin(), runs.end(), [](const Run& r) { return std::isfinite(r.error); });
}

const Run& best(const std::vector<Run>& runs) {
  return *std::min_element(runs.begin(), runs.end(),
                           [](const Run& a, const Run& b) { return a.error < b.error; });
}

// The run from which on a smaller step gains less than half of its error; the last one if every
// step gains.
std::size_t where_it_stalls(const std::vector<Run>& runs) {
  for (std::size_t i = 0; i + 1 < runs.size(); ++i) {
    const double later =
        best({runs.begin() + static_cast<std::ptrdiff_t>(i) + 1, runs.end()}).error;
    if (later > runs[i].error / 2) return i;
  }
  return runs.size() - 1;
}

// The slope of log error over log dt, over the steps below 0.002 s.
double order(const std::vector<Run>& runs) {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (const Run& r : runs) {
    if (r.dt > 2.1e-3 || !(r.error > 0)) continue;
    const double a = std::log(r.dt), b = std::log(r.error);
    n += 1, x += a, y += b, xx += a * a, xy += a * b;
  }
  return (n * xy - x * y) / (n * xx - x * x);
}

std::string reached(double error) {
  return error < kRounding ? "is right to rounding" : "reaches " + length(error);
}

std::string of_steps(const Scene& scene, const Both& runs) {
  if (!is_usable(runs.fixed) || !is_usable(runs.scaled)) return kUnusable;
  const double fixed = runs.fixed.back().error, scaled = runs.scaled.back().error;
  const std::string at_last = " With delta fixed the error ends at " + length(fixed);
  if (scaled > fixed / 2) {
    return accuracy(scene, runs.fixed) + at_last + ", with delta in proportion to dt at " +
           length(scaled) + ": it isn't delta that keeps your program from the truth.";
  }
  return accuracy(scene, runs.fixed) + at_last + ", " + number(fixed / scene.params.delta, "%.2g") +
         " times delta. With delta in proportion to dt it falls to " + length(scaled) +
         ", with order " + number(order(runs.scaled), "%.1f") + " in dt.";
}

std::string of_time(const Scene& scene, const Both& runs, double one_lcp) {
  if (!is_usable(runs.fixed) || !is_usable(runs.scaled)) return kUnusable;
  return in_the_same_time(scene, runs.fixed, one_lcp) +
         " The other methods were measured elsewhere, in calls of solve_lcp; one takes " +
         number(one_lcp * 1e9) + " ns here.";
}

template <class Of>
Points points(const std::vector<Run>& runs, const Of& of) {
  Points all;
  for (const Run& r : runs) all.push_back(of(r));
  return all;
}

}  // namespace

std::vector<Chart> charts_of(const Scene& scene, const Both& runs, double one_lcp) {
  const auto over_time = [](const Run& r) { return std::pair(r.seconds * 1e6, r.error); };
  const auto over_step = [](const Run& r) { return std::pair(r.dt, r.error); };
  std::vector<Line> times{{"yours, delta fixed", points(runs.fixed, over_time)},
                          {"yours, delta = 0.1 m/s dt", points(runs.scaled, over_time)}};
  for (const Method& method : scene.others) {
    Points all;
    for (const Reached& r : method.reached) all.emplace_back(r.lcp_calls * one_lcp * 1e6, r.error);
    times.push_back({method.name, all, "other"});
  }
  const Axis error{"error, m", true};
  return {{"time-" + scene.name,
           scene.title + ": Error over time",
           {"time of a simulated second, \xc2\xb5s here", true},
           error,
           times,
           of_time(scene, runs, one_lcp)},
          {"step-" + scene.name,
           scene.title + ": Error over step",
           {"dt, s", true},
           error,
           {{"delta fixed", points(runs.fixed, over_step)},
            {"delta = 0.1 m/s dt", points(runs.scaled, over_step)}},
           of_steps(scene, runs)}};
}

std::string accuracy(const Scene& scene, const std::vector<Run>& fixed) {
  if (!is_usable(fixed)) return kUnusable;
  const std::size_t at = where_it_stalls(fixed);
  const Run& mine = best(fixed);
  const std::string reaches = scene.title + ": " + length(mine.error) +
                              " off at best, with dt = " + number(mine.dt) + " s.";
  if (at + 1 == fixed.size()) return reaches + " Each smaller step helps.";
  const bool is_best = fixed[at].error <= mine.error;
  return reaches + " Below dt = " + number(fixed[at].dt) + " s a smaller step " +
         (is_best ? "no longer helps" : "takes away less than half of the error") +
         ", while delta stays at " + length(scene.params.delta) + ".";
}

std::string in_the_same_time(const Scene& scene, const std::vector<Run>& fixed, double one_lcp) {
  if (!is_usable(fixed)) return kUnusable;
  const double time = best(fixed).seconds / one_lcp;
  std::string text = "In the time of your best run, and a fifth more,";
  for (const Method& method : scene.others) {
    if (&method == &scene.others.front()) continue;  // the course's program
    double least = INFINITY;
    for (const Reached& r : method.reached) {
      if (r.lcp_calls <= kAboutAsLong * time) least = std::min(least, r.error);
    }
    text += (&method == &scene.others.back() ? ", and the " : " the ") + method.name + " " +
            (std::isfinite(least) ? reached(least) : "takes longer");
  }
  return text + ".";
}

}  // namespace bounce::study
