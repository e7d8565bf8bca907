#include "simulate_to.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>

#include "../methods/moreau_jean.hpp"
#include "event_driven.hpp"

namespace bounce::exact {
namespace {

using methods::Motion;
using Motions = std::vector<Motion<double>>;

constexpr double kRounding = std::numeric_limits<double>::epsilon();
constexpr double kNoise = 0x1p-40;
constexpr double kFelt = kRounding / kNoise;  // what rounding makes of a distance that noise makes
constexpr double kSafety = 16;                // of every measured error
constexpr double kSafetyAlone = 128;          // of that which perturbed motions say
constexpr double kNear = 1e-9;                // of l
constexpr double kSameEvents = 1e-3;          // of l: shadows this near have the same events
constexpr double kStepsAnEvent = 20;          // take as long as an event
constexpr long kMostSteps = 5'000'000;        // of the finest of three runs

double apart(const Parameters& params, const Motion<double>& a, const Motion<double>& b) {
  return std::hypot(a.x - b.x, a.y - b.y, params.l / std::sqrt(2.0) * (a.theta - b.theta));
}

// The rounding of the numbers that say where the square is, m.
double rounding_of(const Parameters& params, const Motion<double>& s) {
  return 4 * kRounding * (std::abs(s.x) + std::abs(s.y) + params.l * std::abs(s.theta));
}

// The largest distance up to each of the times that both have.
std::vector<double> farthest(const Parameters& params, const Motions& a, const Motions& b) {
  std::vector<double> far(std::min(a.size(), b.size()));
  double worst = 0;
  for (std::size_t i = 0; i < far.size(); ++i) {
    const double distance = apart(params, a[i], b[i]);
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

  Answer run() {
    EventReport report;
    EventOptions options;
    options.perturbation = kNoise;
    Motions motions = by_events(options, most_events(), &report);
    if (motions.size() < times_.size()) return by_steps();
    if (report.impacts == 0) return in_flight(std::move(motions));
    if (has_rounding_alone(report)) {
      std::vector<double> bound =
          bound_of(motions, kSafetyAlone * kFelt, report.perturbed_distances);
      return checked(std::move(motions), {std::move(bound), std::move(report.perturbed_distances)});
    }
    const std::optional<Errors> errors = errors_of(motions);
    if (!errors) return by_steps();
    return checked(std::move(motions), *errors);
  }

 private:
  // Up to each time, m.
  struct Errors {
    std::vector<double> bound, shadows;
  };

  double last() const { return times_.back(); }

  double speed() const {
    return std::hypot(start_.v_x, start_.v_y, params_.l * start_.omega) +
           std::sqrt(params_.l * params_.g.norm());
  }

  // Events that would cost more than steps do for this tolerance.
  long most_events() const {
    const double steps = last() * speed() / tolerance_;
    return long(std::clamp(7 * steps / kStepsAnEvent, 5e3, 1e6));
  }

  Motions by_events(EventOptions options, long most, EventReport* report = nullptr) const {
    options.most_events = most;
    return simulate_events<double>(params_, start_, times_, options, report);
  }

  Motions in_long_double(long most) const {
    EventOptions finer;
    finer.cut = 1e-8;
    finer.tolerance = 1e-18;
    finer.touching = 0;  // what counts as touching in double is an error to be measured, too
    finer.most_events = most;
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
  bool has_rounding_alone(const EventReport& report) const {
    const double gap = methods::lowest_gap(start_, methods::Body<double>(params_));
    return report.perturbed_distances.size() == times_.size() && gap > kNear * params_.l;
  }

  // `safety` times the error up to each time, beside the rounding of the numbers themselves.
  std::vector<double> bound_of(const Motions& motions, double safety,
                               std::vector<double> error) const {
    double rounding = 0;
    for (std::size_t i = 0; i < motions.size(); ++i) {
      rounding = std::max(rounding, rounding_of(params_, motions[i]));
      error[i] = safety * error[i] + rounding;
    }
    return error;
  }

  // Of the event-driven motion; none if there are too many events.
  std::optional<Errors> errors_of(const Motions& motions) const {
    const long most = 4 * most_events();
    const Motions finer = in_long_double(most);
    if (finer.size() < motions.size()) return {};
    std::vector<double> shadows(motions.size());
    for (const std::uint64_t seed : {1UL, 2UL}) {
      EventOptions disturbed;
      disturbed.noise = kNoise;
      disturbed.seed = seed;
      const Motions shadow = by_events(disturbed, most);
      if (shadow.size() < motions.size()) return {};
      const std::vector<double> far = farthest(params_, motions, shadow);
      for (std::size_t i = 0; i < far.size(); ++i) shadows[i] = std::max(shadows[i], far[i]);
    }
    std::vector<double> error = farthest(params_, motions, finer);
    for (std::size_t i = 0; i < error.size(); ++i)
      error[i] = std::max(error[i], shadows[i] * kFelt);
    return Errors{bound_of(motions, kSafety, std::move(error)), std::move(shadows)};
  }

  Answer checked(Motions motions, const Errors& errors) const {
    for (std::size_t i = 0; i < motions.size(); ++i) {
      if (errors.shadows[i] > kSameEvents * params_.l) {
        refuse(i,
               "a change of 1e-12 there becomes one of a thousandth of l, and the order or kind "
               "of an impact may be another");
      }
      if (!(errors.bound[i] <= tolerance_))
        refuse(i, "the bound of the error grows to " + text_of(errors.bound[i]) + " m there");
    }
    return {times_, std::move(motions), "event-driven", 0, errors.bound.back(), last()};
  }

  [[noreturn]] void refuse(std::size_t i, const std::string& why) const {
    const double horizon = i == 0 ? 0 : times_[i - 1];
    throw Refusal("within " + text_of(tolerance_) + " m the motion can be had up to " +
                      text_of(horizon) + " s and not to " + text_of(last()) + " s: " + why,
                  horizon);
  }

  // The terms of x, y and theta, rounded a few times each.
  Answer in_flight(Motions motions) const {
    const double t = last(), half = t * t / 2;
    const double terms = std::abs(start_.x) + std::abs(start_.y) + std::abs(start_.v_x * t) +
                         std::abs(start_.v_y * t) + params_.g.norm() * half +
                         params_.l * (std::abs(start_.theta) + std::abs(start_.omega * t));
    const double bound = 4 * kRounding * terms;
    if (!(bound <= tolerance_))
      refuse(0, "the rounding of such large numbers is " + text_of(bound) + " m");
    return {times_, std::move(motions), "free flight", 0, bound, t};
  }

  // Moreau-Jean with whole turns taken out of theta, for its sums.
  Motions stepped(long steps) const {
    Parameters params = params_;
    params.dt /= double(steps);
    Motion<double> start = start_;
    start.theta = std::atan2(std::sin(start.theta), std::cos(start.theta));
    methods::MoreauJean<2> scheme(params, start);
    Motions motions{start_};
    while (motions.size() < times_.size()) {
      scheme.steps(steps);
      Motion<double> s = scheme.motion();
      s.theta += start_.theta - start.theta;
      motions.push_back(s);
    }
    return motions;
  }

  Answer by_steps() const {
    const double columns = double(times_.size());
    long steps = std::max(1L, std::lround(params_.dt * speed() / tolerance_));
    for (; 4 * double(steps) * columns <= double(kMostSteps); steps *= 4) {
      const Motions finest = stepped(4 * steps);
      const double error = std::max(farthest(params_, finest, stepped(2 * steps)).back(),
                                    farthest(params_, finest, stepped(steps)).back());
      const double step = params_.dt / double(4 * steps);
      const double unseen = params_.g.norm() * step * step;  // hops shorter than a step
      const double bound = kSafety * (error + unseen) + rounding_of(params_, finest.back());
      if (bound <= tolerance_) {
        return {times_, finest, "Moreau-Jean, two corners", params_.dt / double(4 * steps),
                bound,  last()};
      }
    }
    refuse(0, "there are too many events, and steps do not come near enough");
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
