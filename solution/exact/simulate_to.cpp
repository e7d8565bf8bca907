#include "simulate_to.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "truth.hpp"

namespace bounce::study {
namespace {

constexpr double kRounding = std::numeric_limits<double>::epsilon();
constexpr double kNoise = 0x1p-40;
constexpr double kFelt = kRounding / kNoise;  // what rounding makes of a distance that noise makes
constexpr double kSafety = 16;                // of the error, where corners stay on the ground
constexpr double kSafetyOfRounding = 2;       // where rounding alone makes it
constexpr double kFeltFiner = kFelt / 16;     // of what rounding still does in long double
constexpr double kNear = 1e-9;                // of l, from where rounding decides what touches
constexpr double kSameEvents = 1e-3;          // of l: motions this near have the same events
constexpr long kMostEvents = 100'000;         // of the motion; a check may take twice as many

class Simulation {
 public:
  Simulation(const Scene& scene, double tolerance) : scene_(scene), tolerance_(tolerance) {
    for (int i = 0; i < scene.params.T; ++i) times_.push_back(i * scene.params.dt);
  }

  Answer run() const {
    EventReport report;
    const Motions motions = in_double(kMostEvents, &report);
    const Checks checks = check(motions, report);
    double rounding = 0, bound = 0;
    for (std::size_t i = 0; i < times_.size(); ++i) {
      if (i >= checks.finer.size() || i >= checks.shadows.size()) {
        refuse(
            i,
            "no motion was found there: its impacts go on without an end, or there are more than " +
                std::to_string(kMostEvents));
      }
      if (checks.shadows[i] > kSameEvents * scene_.params.l) {
        refuse(i,
               "a change of 1e-12 there becomes one of a thousandth of l, and the order or kind "
               "of an impact may be another");
      }
      const Motion<double>& s = motions[i];  // whose numbers are rounded, too
      const double size = std::abs(s.x) + std::abs(s.y) + scene_.params.l * std::abs(s.theta);
      rounding = std::max(rounding, kRounding / 2 * size);
      bound = checks.bound(i) + rounding;
      if (!(bound <= tolerance_))
        refuse(i, "the bound of the error grows to " + text_of(bound) + " m there");
    }
    return {times_, motions, report.impacts == 0 ? "free flight" : "event-driven", bound};
  }

 private:
  // How far the motion is from others, up to each time, m.
  struct Checks {
    std::vector<double> finer, shadows;
    bool rounds_alone;

    double bound(std::size_t i) const {
      return rounds_alone ? kSafetyOfRounding * finer[i] + kFeltFiner * shadows[i]
                          : kSafety * std::max(finer[i], kFelt * shadows[i]);
    }
  };

  Checks check(const Motions& motions, const EventReport& report) const {
    EventReport of_finer;
    // Nothing counts as touching: what does in double is an error to be measured, too.
    const Motions precise = in_long_double(
        scene_, {times_.begin(), times_.end()},
        {.cut = 1e-8, .tolerance = 1e-18, .touching = 0, .most_events = 2 * kMostEvents},
        &of_finer);
    const double gap = lowest_gap(motion_of(scene_.start), Body<double>(scene_.params));
    const bool bounces = gap > kNear * scene_.params.l && !report.stays && !of_finer.stays &&
                         report.impacts == of_finer.impacts;
    const auto shadow = [&](unsigned seed) {
      return farthest(scene_, motions, in_double(2 * kMostEvents, nullptr, kNoise, seed));
    };
    std::vector<double> shadows = shadow(1'000'003);
    const std::vector<double> others = shadow(500'009);
    shadows.resize(std::min(shadows.size(), others.size()));
    for (std::size_t i = 0; i < shadows.size(); ++i) shadows[i] = std::max(shadows[i], others[i]);
    return {farthest(scene_, motions, precise), shadows, bounces};
  }

  Motions in_double(long most_events, EventReport* report, double noise = 0,
                    unsigned seed = 1) const {
    return simulate_events<double>(scene_.params, motion_of(scene_.start), times_,
                                   {.most_events = most_events, .noise = noise, .seed = seed},
                                   report);
  }

  [[noreturn]] void refuse(std::size_t i, const std::string& why) const {
    const double horizon = i == 0 ? 0 : times_[i - 1];
    throw Refusal("within " + text_of(tolerance_) + " m the motion can be had up to " +
                      text_of(horizon) + " s and not to " + text_of(times_.back()) + " s: " + why,
                  horizon);
  }

  const Scene& scene_;
  double tolerance_;
  std::vector<double> times_;
};

}  // namespace

Answer simulate_to(const Scene& scene, double tolerance) {
  if (!(tolerance > 0 && std::isfinite(tolerance))) {
    throw std::invalid_argument("the tolerance is " + text_of(tolerance) +
                                " m; it must be above 0 and finite");
  }
  return Simulation(scene, tolerance).run();
}

}  // namespace bounce::study
