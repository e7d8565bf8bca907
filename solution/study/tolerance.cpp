#include <algorithm>
#include <limits>

#include "../exact/event_driven.hpp"
#include "../exact/simulate_to.hpp"
#include "../exact/truth.hpp"
#include "../methods/moreau_jean.hpp"
#include "../methods/scheme.hpp"
#include "questions.hpp"
#include "random_scenes.hpp"

namespace bounce::study {
namespace {

// CPU time of a run, ns: the least of five, since one alone may be disturbed.
template <class Run>
double least_time(const Run& run) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 5; ++i) {
    const double begin = cpu_ns();
    run();
    least = std::min(least, cpu_ns() - begin);
  }
  return least;
}

// The time of a run that comes within the tolerance, ns; infinite for one that doesn't.
template <class Run>
double time_within(const Scene& scene, const Motions& truth, double tolerance, const Run& run) {
  return error_of(scene, run(), truth) <= tolerance ? least_time(run)
                                                    : std::numeric_limits<double>::infinity();
}

Motions stepped(const Scene& scene, long steps) {
  Parameters params = scene.params;
  params.dt /= double(steps);
  const auto start = motion_of(scene.start);
  Motions motions = sample(MoreauJean<2>(params), start, params.T - 1, steps);
  motions.insert(motions.begin(), start);
  return motions;
}

// The time of the best choice of method and setting, once the truth is known, ns.
double best_time(const Scene& scene, const std::vector<double>& times, const Motions& truth,
                 double tolerance) {
  double best = std::numeric_limits<double>::infinity();
  for (const auto& [of_series, cut] : {std::pair{1e-15, 1e-6}, {1e-8, 1e-4}, {1e-5, 3e-3}}) {
    const EventOptions options{.cut = cut, .tolerance = of_series};
    const auto start = motion_of(scene.start);
    best = std::min(best, time_within(scene, truth, tolerance, [&] {
                      return simulate_events<double>(scene.params, start, times, options);
                    }));
  }
  for (const long steps : {1, 4, 16, 64}) {
    best =
        std::min(best, time_within(scene, truth, tolerance, [&] { return stepped(scene, steps); }));
  }
  return best;
}

}  // namespace

Table tolerance(const Scenes&, const Extent& extent) {
  const int count = extent.is_quick ? 400 : 4000;
  Table table({"tolerance_m", "scenes", "free_flight", "event_driven", "refused", "violated",
               "bound_over_error", "bound_over_error_90", "time_over_best", "time_over_best_90",
               "ns"});
  for (const double within : {1e-3, 1e-6, 1e-9}) {
    Random random(31);
    int flights = 0, refused = 0, violated = 0;
    std::vector<double> bounds, times_over_best, ns;
    for (int i = 0; i < count; ++i) {
      const Scene scene = random_scene(random);
      try {
        const Answer answer = simulate_to(scene, within);
        ns.push_back(least_time([&] { simulate_to(scene, within); }));
        flights += answer.method == "free flight";
        const Motions truth = second_truth(scene, answer.times);
        const double error = error_of(scene, answer.motions, truth);
        violated += !(error <= answer.bound);
        if (error > 0) bounds.push_back(answer.bound / error);
        times_over_best.push_back(ns.back() / best_time(scene, answer.times, truth, within));
      } catch (const Refusal&) {
        ++refused;
      }
    }
    table.add(within, count, flights, count - refused - flights, refused, violated,
              quantile(bounds), quantile(bounds, 0.9), quantile(times_over_best),
              quantile(times_over_best, 0.9), quantile(ns));
  }
  return table;
}

}  // namespace bounce::study
