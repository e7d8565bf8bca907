#include "simulate_to.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "event_driven.hpp"

namespace bounce::exact {
namespace {

using methods::Motion;
using Motions = std::vector<Motion<double>>;

constexpr double kRounding = std::numeric_limits<double>::epsilon();
constexpr double kNoise = 0x1p-40;
constexpr double kFelt = kRounding / kNoise;  // what rounding makes of a distance that noise makes
constexpr double kSafety = 16;                // of the errors that whole simulations say
constexpr double kSafetyAlone = 2;            // of the distance to the same events in long double
constexpr double kFeltFiner = kFelt / 16;     // of what rounding still does to that
constexpr double kNear = 1e-9;                // of l
constexpr double kSameEvents = 1e-3;          // of l: motions this near have the same events
constexpr long kMostEvents = 100'000;         // of the motion; a check may take twice as many

// The rounding of the numbers that say where the square is, m.
double rounding_of(const Parameters& params, const Motion<double>& s) {
  return kRounding / 2 * (std::abs(s.x) + std::abs(s.y) + params.l * std::abs(s.theta));
}

// The largest distance up to each of the times that both have.
std::vector<double> farthest(const Parameters& params, const Motions& a, const Motions& b) {
  std::vector<double> far(std::min(a.size(), b.size()));
  double worst = 0;
  for (std::size_t i = 0; i < far.size(); ++i) {
    const double distance = apart(a[i], b[i], params.l / std::sqrt(2.0));
    far[i] = worst = distance <= worst ? worst : distance;
    if (std::isnan(worst)) far[i] = worst = std::numeric_limits<double>::infinity();
  }
  return far;
}

std::string text_of(double x) {
  std::ostringstream text;
  text << x;
  return text.str();
}

class Simulation {
 public:
  Simulation(const Scene& scene, double tolerance)
      : params_(scene.params),
        start_(methods::motion_of<double>(scene.start)),
        tolerance_(tolerance) {
    times_.reserve(std::size_t(params_.T));
    for (int i = 0; i < params_.T; ++i) times_.push_back(i * params_.dt);
  }

  Answer run() const {
    EventReport report;
    EventOptions options;
    options.perturbation = kNoise;
    Motions motions = by_events(options, kMostEvents, &report);
    if (report.impacts == 0)
      return checked(std::move(motions), errors_alone(report), "free flight");
    const Errors errors =
        has_rounding_alone(report, motions) ? errors_alone(report) : errors_of(motions);
    return checked(std::move(motions), errors, "event-driven");
  }

 private:
  // Up to each time, m.
  struct Errors {
    std::vector<double> bound, shadows;
  };

  double last() const { return times_.back(); }

  Motions by_events(EventOptions options, long most, EventReport* report = nullptr) const {
    options.most_events = most;
    return simulate_events<double>(params_, start_, times_, options, report);
  }

  Motions in_long_double() const {
    EventOptions finer;
    finer.cut = 1e-8;
    finer.tolerance = 1e-18;
    finer.touching = 0;  // what counts as touching in double is an error to be measured, too
    finer.most_events = 2 * kMostEvents;
    const std::vector<long double> times(times_.begin(), times_.end());
    const Motion<long double> start{start_.x,   start_.y,   start_.theta,
                                    start_.v_x, start_.v_y, start_.omega};
    Motions rounded;
    for (const auto& s : simulate_events<long double>(params_, start, times, finer)) {
      rounded.push_back({double(s.x), double(s.y), double(s.theta), double(s.v_x), double(s.v_y),
                         double(s.omega)});
    }
    return rounded;
  }

  // Whether the motion has no error but the rounding of its flights and impacts, since corners
  // never stay on the ground, and rounding decides neither whether nor which of them is first.
  bool has_rounding_alone(const EventReport& report, const Motions& motions) const {
    const double gap = methods::lowest_gap(start_, methods::Body<double>(params_));
    return report.distances.size() == motions.size() && gap > kNear * params_.l;
  }

  // Where the carried motions say how far rounding comes: by the distance to the same events in
  // long double, whose own rounding is a small share of what the perturbed ones show.
  static Errors errors_alone(const EventReport& report) {
    const std::size_t count = report.distances.size();
    Errors errors{std::vector<double>(count), std::vector<double>(count)};
    for (std::size_t i = 0; i < count; ++i) {
      const auto [perturbed, finer] = report.distances[i];
      errors.bound[i] = kSafetyAlone * finer + kFeltFiner * perturbed;
      errors.shadows[i] = perturbed;
    }
    return errors;
  }

  // Where only whole simulations say it: two shadows, and one in long double. Up to where all of
  // them come.
  Errors errors_of(const Motions& motions) const {
    Errors errors{farthest(params_, motions, in_long_double()), {}};
    for (const std::uint64_t seed : {1UL, 2UL}) {
      EventOptions disturbed;
      disturbed.noise = kNoise;
      disturbed.seed = seed;
      const auto far = farthest(params_, motions, by_events(disturbed, 2 * kMostEvents));
      errors.shadows.resize(std::max(errors.shadows.size(), far.size()));
      errors.bound.resize(std::min(errors.bound.size(), far.size()));
      for (std::size_t i = 0; i < far.size(); ++i)
        errors.shadows[i] = std::max(errors.shadows[i], far[i]);
    }
    for (std::size_t i = 0; i < errors.bound.size(); ++i)
      errors.bound[i] = kSafety * std::max(errors.bound[i], kFelt * errors.shadows[i]);
    return errors;
  }

  Answer checked(Motions motions, const Errors& errors, const char* method) const {
    double rounding = 0, bound = 0;
    for (std::size_t i = 0; i < times_.size(); ++i) {
      if (i >= errors.bound.size()) {
        refuse(
            i,
            "no motion was found there: its impacts go on without an end, or there are more than " +
                std::to_string(kMostEvents));
      }
      if (errors.shadows[i] > kSameEvents * params_.l) {
        refuse(i,
               "a change of 1e-12 there becomes one of a thousandth of l, and the order or kind "
               "of an impact may be another");
      }
      rounding = std::max(rounding, rounding_of(params_, motions[i]));
      bound = errors.bound[i] + rounding;
      if (!(bound <= tolerance_))
        refuse(i, "the bound of the error grows to " + text_of(bound) + " m there");
    }
    return {times_, std::move(motions), method, bound, last()};
  }

  [[noreturn]] void refuse(std::size_t i, const std::string& why) const {
    const double horizon = i == 0 ? 0 : times_[i - 1];
    throw Refusal("within " + text_of(tolerance_) + " m the motion can be had up to " +
                      text_of(horizon) + " s and not to " + text_of(last()) + " s: " + why,
                  horizon);
  }

  const Parameters& params_;
  Motion<double> start_;
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

}  // namespace bounce::exact
