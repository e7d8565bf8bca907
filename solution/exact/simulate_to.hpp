// A tolerance in, a trajectory out that keeps it, with a bound of its error.
//
// The truth is the exact motion under the assignment's law of impact (eq. 8, Newton's restitution
// and Coulomb's friction) in continuous time, from the given start. The error is the distance of
// poses, (dx, dy, l / sqrt 2 dtheta), the largest up to a time, m.
//
// The motion is event-driven, in double. As long as there are only impacts of single corners, its
// error is that of rounding, and the same events in long double are carried along with it
// (carried_motions.hpp): the bound is twice the distance to them. Rounding in long double is
// another 2^-11 of that in double, and what it may hide is added: two perturbed motions say how
// rounding grows, each event changes them by 2^-40 in place of 2^-52, and a sixteenth of 2^-12
// times their distance is more than long double does.
//
// Where corners or sides stay on the ground, or rounding decides which corner is first, whole
// simulations take the place of the carried motions: two shadows with the same noise, and one in
// long double with finer tolerances. The bound is then 16 times the larger of the distance to that
// one and 2^-12 times the distance to the shadows. The rounding of the numbers themselves is added.
//
// The horizon is the time up to which the tolerance is kept. It ends where the bound exceeds the
// tolerance; where a perturbed motion is a thousandth of l away, because the order or the kind of
// an impact may be another there; or after a hundred thousand events.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "scene.hpp"

namespace bounce::exact {

struct Answer {
  std::vector<double> times;                     // s
  std::vector<methods::Motion<double>> motions;  // at these
  std::string method;                            // "free flight" or "event-driven"
  double bound;                                  // of the error at all times, m
  double horizon;                                // the last of the times, s
};

// Thrown if the tolerance can't be kept until the last time; `horizon` is until when it can.
struct Refusal : std::runtime_error {
  Refusal(const std::string& why, double until) : std::runtime_error(why), horizon(until) {}
  double horizon;  // s
};

// The motion at the scene's T times, dt apart. Throws std::invalid_argument if the tolerance is not
// above 0 and finite, Refusal if the bound can't be kept below it until the last time.
Answer simulate_to(const Scene& scene, double tolerance);

}  // namespace bounce::exact
