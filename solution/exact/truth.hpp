// The exact motion, against which methods and submissions are measured.
#pragma once

#include <vector>

#include "event_driven.hpp"
#include "scene.hpp"

namespace bounce::study {

// The square at evenly spaced times up to scene.until, kSamples by default. Between them an error
// may be larger.
inline constexpr int kSamples = 20;

template <class Real>
std::vector<Real> even_times(Real until, int count = kSamples) {
  std::vector<Real> times;
  for (int i = 1; i <= count; ++i) times.push_back(until * Real(i) / Real(count));
  return times;
}

// The truth: event-driven in long double, with tolerances a thousandth of any method's, so that
// even the error of the event-driven method in double can be measured. Throws std::runtime_error if
// it stalled.
Motions truth_of(const Scene& scene, int samples = kSamples);

// Once more at these times, with other tolerances and other rounding than those that the truth and
// simulate_to's bounds are made of.
Motions second_truth(const Scene& scene, const std::vector<double>& times);

// The motion of a scene in long double, rounded in the end.
Motions in_long_double(const Scene& scene, const std::vector<long double>& times,
                       const EventOptions& options, EventReport* report = nullptr);

// The largest distance up to each of the times that both have, m; infinite from one on that is not
// finite.
std::vector<double> farthest(const Scene& scene, const Motions& one, const Motions& other);

// The largest over all samples, m; infinite if some are missing.
double error_of(const Scene& scene, const Motions& samples, const Motions& truth);

// The step nearest to dt of which a whole number makes up the time between two samples.
double fitting_step(const Scene& scene, double dt, int samples = kSamples);

}  // namespace bounce::study
