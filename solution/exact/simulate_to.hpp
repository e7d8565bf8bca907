// A tolerance in, the cheapest trajectory out that keeps it, with a bound of its error.
//
// The truth is the exact motion under the assignment's law of impact (eq. 8, Newton's restitution
// and Coulomb's friction) in continuous time, from the given start. The error is the distance of
// poses, (dx, dy, l / sqrt 2 dtheta), the largest up to a time, m.
//
//   free flight    no impact until the last time: closed form, bounded by its rounding.
//   event-driven   in double. As long as there are only impacts of single corners, its error is
//                  that of rounding, and two perturbed motions say how it grows: each event
//                  changes them by 2^-40 in place of rounding's 2^-52. The bound is 128 times 2^-12
//                  times their distance. Where corners or sides stay on the ground, or rounding
//                  decides which corner is first, there are two shadows, which are simulated anew
//                  with the same noise, and the motion in long double with finer tolerances. The
//                  bound is then the larger of 16 times 2^-12 times the distance to the shadows
//                  and 16 times the distance to the motion in long double. The rounding of the
//                  numbers themselves is added.
//   Moreau-Jean    where events are too many: more than they would cost as steps. Its error is
//                  measured with steps half and a quarter as long, and the motion with the shortest
//                  steps is returned. Hops that are shorter than a step, g dt^2 high, are missed.
//
// The horizon is the time up to which the tolerance is kept. It ends where the bound exceeds the
// tolerance, or where a shadow is a thousandth of l away, because the order or the kind of an
// impact may be another there.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "scene.hpp"

namespace bounce::exact {

struct Answer {
  std::vector<double> times;                     // s
  std::vector<methods::Motion<double>> motions;  // at these
  std::string method;
  double step;     // of the motion returned, s; 0 where the method has none
  double bound;    // of the error at all times, m
  double horizon;  // the last of the times, s
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
