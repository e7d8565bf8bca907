// The interface of every scheme: a class that is constructed from the parameters and the start,
// with
//
//     void steps(long n);               makes n steps of dt
//     Motion<double> motion() const;    where the square is, and how it moves
//
// so that a sweep runs all of them with one loop. params.dt is the step.
#pragma once

#include <vector>

#include "square.hpp"

namespace bounce::methods {

// The motion after each of `samples` times `steps` steps.
template <class Scheme>
std::vector<Motion<double>> sample(Scheme scheme, int samples, long steps) {
  std::vector<Motion<double>> motions;
  motions.reserve(std::size_t(samples));
  for (int i = 0; i < samples; ++i) {
    scheme.steps(steps);
    motions.push_back(scheme.motion());
  }
  return motions;
}

}  // namespace bounce::methods
