// A tolerance in, a trajectory out that keeps it, with a bound of its error.
//
// The truth is the exact motion under the assignment's law of impact (eq. 8, Newton's restitution
// and Coulomb's friction) in continuous time, from the given start. The error is the distance of
// poses, (dx, dy, l / sqrt 2 dtheta), the largest up to a time, m.
//
// The motion is event-driven, in double. Three more simulations say how far it is off: one in long
// double with finer tolerances, and two shadows, which noise of 2^-40 changes at each event, far
// more than rounding does: they say how fast errors grow. There are two, because one alone may
// happen to be changed in a direction that hardly grows.
//
// As long as corners only bounce, rounding alone makes the error, and in long double it is 2^-11 of
// that. So the bound is twice the distance to the motion in long double, and a sixteenth of 2^-12
// times the distance to the shadows, which is more than long double may hide. Where a corner or a
// side stays on the ground or begins there, or long double has other impacts, it is 16 times the
// larger of the distance to that motion and 2^-12 times the distance to the shadows. The rounding
// of the numbers themselves is added.
//
// The horizon is the time up to which the tolerance is kept. It ends where the bound exceeds the
// tolerance; where a shadow is a thousandth of l away, because the order or the kind of
// an impact may be another there; or after a hundred thousand events.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "scene.hpp"

namespace bounce::study {

struct Answer {
  std::vector<double> times;  // s
  Motions motions;            // at these
  std::string method;         // "free flight" or "event-driven"
  double bound;               // of the error at all times, m
};

// Thrown if the tolerance can't be kept until the last time; `horizon` is until when it can.
struct Refusal : std::runtime_error {
  Refusal(const std::string& why, double until) : std::runtime_error(why), horizon(until) {}
  double horizon;  // s
};

// The motion at the scene's T times, dt apart. Throws std::invalid_argument if the tolerance is not
// above 0 and finite, Refusal if the bound can't be kept below it until the last time.
Answer simulate_to(const Scene& scene, double tolerance);

}  // namespace bounce::study
