#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "../exact/truth.hpp"
#include "../methods/impact_laws.hpp"
#include "questions.hpp"

namespace bounce::study {
namespace {

// Kane's paradox: the energy after the impact over that before.
double kane(ImpactLaw law) {
  const Body<double> body({.epsilon = 0.9, .g = {0, 0, 0}});
  Motion<double> s{0, 0.104267, 0.043633, 0.040023, -0.396829, 6.313089};
  const auto r = lowest_arm(body.half, std::cos(s.theta), std::sin(s.theta));
  const double before = energy(s, body);
  const auto p = impact(collision_of(s, r, body), law);
  apply_impulse(s, r, p.n, p.t, body.gyration_squared);
  return energy(s, body) / before;
}

struct Least {
  double value, tan_alpha;
};

// The least over the angles in which a rectangle can lean.
template <class Value>
Least least_over_angles(const Value& value) {
  Least least{1e300, 0};
  for (int i = 1; i < 20'000; ++i) {
    const double alpha = i * std::numbers::pi / 40'000;
    const auto k = leaning_corner(alpha, 0, 0, 0);
    if (value(k) < least.value) least = {value(k), std::tan(alpha)};
  }
  return least;
}

bool is_still(const Scene& scene, const Motion<double>& s) {
  return std::hypot(s.v_x, s.v_y, scene.params.l * s.omega) < 1e-6;
}

bool is_flat(const Motion<double>& s) { return std::abs(std::sin(2 * s.theta)) < 1e-9; }

const char* ending(const Scene& scene, const Motion<double>& s) {
  if (lowest_gap(s, Body<double>(scene.params)) > 1e-6 * scene.params.l) return "in the air";
  if (is_still(scene, s)) return is_flat(s) ? "at rest" : "balanced on a corner";
  return is_flat(s) ? "sliding" : "on a corner";
}

}  // namespace

Table examples(const Scenes&, const Extent&) {
  Table table({"example", "quantity", "value", "unit"});
  table.add("kane", "energy after / before, Newton", kane(ImpactLaw::newton), "none");
  table.add("kane", "energy after / before, Poisson", kane(ImpactLaw::poisson), "none");
  table.add("kane", "energy after / before, Stronge", kane(ImpactLaw::stronge), "none");
  const Least epsilon =
      least_over_angles([](const auto& k) { return std::sqrt(1 - k.b * k.b / (k.a * k.c)); });
  table.add("rectangle", "least epsilon that can gain", epsilon.value, "none");
  const Least mu = least_over_angles([](const auto& k) { return k.a / std::abs(k.b); });
  table.add("rectangle", "least mu with a <= mu |b|", mu.value, "none");
  table.add("rectangle", "tan alpha there", mu.tan_alpha, "none");
  constexpr double kMu = 2, kApproach = 0.1, kSliding = 1;
  std::vector<double> impulses;
  for (const auto& p : all_solutions(leaning_corner(std::atan(0.5), kApproach, kSliding, kMu)))
    impulses.push_back(p.n);
  std::sort(impulses.begin(), impulses.end());
  table.add("painleve", "mu", kMu, "none");
  table.add("painleve", "p_1", kApproach, "m/s");
  table.add("painleve", "v_t", kSliding, "m/s");
  table.add("painleve", "solutions", impulses.size(), "none");
  for (const double impulse : impulses) table.add("painleve", "f_n dt / m", impulse, "m/s");
  return table;
}

Table endings(const Scenes& scenes, const Extent&) {
  constexpr int kLooks = 1000;
  Table table({"scene", "impacts", "ending", "still_from_s"});
  for (const Scene& scene : scenes) {
    EventReport report;
    const std::vector<double> times = even_times(scene.until, kLooks);
    const auto start = motion_of(scene.start);
    Motions motions = simulate_events<double>(scene.params, start, times, {}, &report);
    std::size_t moving = motions.size();
    while (moving > 0 && is_still(scene, motions[moving - 1])) --moving;
    const bool stops = moving > 0 && moving < motions.size();
    table.add(scene.name, report.impacts, ending(scene, motions.back()),
              stops ? text_of(times[moving], 2) : "");
  }
  return table;
}

Table truths(const Scenes& scenes, const Extent&) {
  constexpr int kAllDigits = 17;
  Table table({"scene", "t_s", "x_m", "y_m", "theta_rad"});
  for (const Scene& scene : scenes) {
    const std::vector<double> times = even_times(scene.until);
    const Motions truth = truth_of(scene);
    for (std::size_t i = 0; i < truth.size(); ++i) {
      table.add(scene.name, text_of(times[i], kAllDigits), text_of(truth[i].x, kAllDigits),
                text_of(truth[i].y, kAllDigits), text_of(truth[i].theta, kAllDigits));
    }
  }
  return table;
}

}  // namespace bounce::study
