#include "sentences.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "numbers.hpp"

namespace bounce::study {
namespace {

constexpr const char* kUnusable =
    "Your program returns NaN, or another number of columns, somewhere here: ./check says where.";

bool is_usable(const std::vector<Run>& runs) {
  return std::all_of(runs.begin(), runs.end(), [](const Run& r) { return std::isfinite(r.error); });
}

const Run& best(const std::vector<Run>& runs) {
  return *std::min_element(runs.begin(), runs.end(),
                           [](const Run& a, const Run& b) { return a.error < b.error; });
}

// The least error of a method in no more than this time.
std::optional<Reached> within(const Method& method, double lcp_calls) {
  std::optional<Reached> least;
  for (const Reached& r : method.reached) {
    if (r.lcp_calls <= lcp_calls && (!least || r.error < least->error)) least = r;
  }
  return least;
}

}  // namespace

std::size_t where_it_stalls(const std::vector<Run>& runs) {
  for (std::size_t i = 0; i + 1 < runs.size(); ++i) {
    const double later =
        best({runs.begin() + static_cast<std::ptrdiff_t>(i) + 1, runs.end()}).error;
    if (later > runs[i].error / 2) return i;
  }
  return runs.size() - 1;
}

double order(const std::vector<Run>& runs) {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (const Run& r : runs) {
    if (r.dt > 2.1e-3 || !(r.error > 0)) continue;
    const double a = std::log(r.dt), b = std::log(r.error);
    n += 1, x += a, y += b, xx += a * a, xy += a * b;
  }
  return (n * xy - x * y) / (n * xx - x * x);
}

std::string of_steps(const Scene& scene, const Both& runs) {
  if (!is_usable(runs.fixed) || !is_usable(runs.scaled)) return kUnusable;
  const std::size_t at = where_it_stalls(runs.fixed);
  const double fixed = runs.fixed.back().error, scaled = runs.scaled.back().error;
  if (at + 1 == runs.fixed.size()) {
    return "With delta fixed, a smaller step helps down to dt = " + number(runs.fixed[at].dt) +
           " s, and the error falls to " + length(fixed) + ".";
  }
  const std::string stalls = "With delta fixed, from dt = " + number(runs.fixed[at].dt) +
                             " s on a smaller step no longer helps: ";
  if (scaled > fixed / 2) {
    return stalls + "the error ends at " + length(fixed) +
           ". With delta in proportion to dt it ends at " + length(scaled) +
           ": it isn't delta that keeps your program from the truth.";
  }
  return stalls + "delta stays, and the error ends at " + length(fixed) + ", " +
         number(fixed / scene.params.delta, "%.2g") +
         " times delta. With delta in proportion to dt it falls to " + length(scaled) +
         ", with order " + number(order(runs.scaled), "%.1f") + " in dt.";
}

std::string of_time(const Scene& scene, const Both& runs) {
  if (!is_usable(runs.fixed) || !is_usable(runs.scaled)) return kUnusable;
  const Run& mine = best(runs.fixed);
  std::string text = "The best that your program reaches with delta fixed is " +
                     length(mine.error) + ", with dt = " + number(mine.dt) + " s.";
  for (const Method& method : scene.others) {
    if (method.name.rfind("assignment", 0) == 0) continue;
    const auto reached = within(method, mine.lcp_calls);
    text += reached
                ? " In no more time the " + method.name + " reaches " + length(reached->error) + "."
                : " The " + method.name + " takes more time than that with each of its steps.";
  }
  return text;
}

std::string of_depth(const std::vector<Run>& runs, double l) {
  if (!is_usable(runs)) return kUnusable;
  const auto said = [&](const Run& r) {
    const std::string with = "ith dt = " + number(r.dt) + " s the corner ";
    return r.depth > 0 ? with + "sinks in by " + length(r.depth) + ", " +
                             number(100 * r.depth / l, "%.2g") + " % of the side"
                       : with + "doesn't sink in";
  };
  return "W" + said(runs.front()) + "; w" + said(runs.back()) +
         ". In the step in which it lands a corner falls by up to v dt before contact can be "
         "noticed.";
}

std::string of_energy(const Energy& coarse, const Energy& fine) {
  if (coarse.t.empty() || fine.t.empty()) return kUnusable;
  if (!(coarse.largest_gain > 1e-9)) return "The energy never rises.";
  const auto percent = [](double share) { return number(100 * share, "%.2g") + " %"; };
  const double gain = std::max(coarse.largest_gain, fine.largest_gain) / fine.lift;
  return "In a single step the energy rises by up to " + percent(coarse.largest_gain) +
         " of that at the start, with dt = 0.01 s, and by " + percent(fine.largest_gain) +
         " with dt = 0.001 s. The lift alone adds " + percent(fine.lift) +
         (gain > 2     ? ", so most of it comes from somewhere else."
          : gain > 1.2 ? ", so some of it comes from somewhere else."
                       : " to a step in contact, energy from nowhere; an impact takes some away.");
}

std::string of_rest(const Rest& fixed, const Rest& scaled, const Rest& fine_scaled) {
  if (!std::isfinite(fixed.height + scaled.height + fine_scaled.height)) return kUnusable;
  const bool is_less = fine_scaled.height < fixed.height / 2 && fine_scaled.drift < fixed.drift / 2;
  return "In ten seconds a square that should lie still moves by up to " + length(fixed.height) +
         " up and down and " + length(fixed.drift) +
         " along the ground, with dt = 0.01 s. With dt = 0.001 s and delta in proportion it is " +
         length(fine_scaled.height) + " and " + length(fine_scaled.drift) +
         (is_less ? ": one corner can't hold a face, but with a smaller step it moves less."
                  : ": it isn't the step that moves it.");
}

}  // namespace bounce::study
