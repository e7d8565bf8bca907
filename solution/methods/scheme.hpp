// The interface of every scheme: a class that is constructed from the parameters, with
//
//     void step(Motion<double>& s) const;    moves the square on by dt
//
// so that a sweep runs all of them with one loop.
#pragma once

#include "square.hpp"

namespace bounce::study {

// What a step needs of the parameters: the body; dt, s; delta, m; and dt g, m/s.
struct StepConstants : Body<double> {
  double dt, delta, dv_x, dv_y;

  explicit StepConstants(const Parameters& params)
      : Body(params),
        dt(params.dt),
        delta(params.delta),
        dv_x(params.dt * params.g.x()),
        dv_y(params.dt * params.g.y()) {}
};

inline void move(Motion<double>& s, double time) {
  s.x += time * s.v_x;
  s.y += time * s.v_y;
  s.theta += time * s.omega;
}

// The motion after each of `samples` times `steps` steps.
template <class Scheme>
Motions sample(const Scheme& scheme, Motion<double> s, int samples, long steps) {
  Motions motions;
  motions.reserve(std::size_t(samples));
  for (int i = 0; i < samples; ++i) {
    for (long n = 0; n < steps; ++n) scheme.step(s);
    motions.push_back(s);
  }
  return motions;
}

}  // namespace bounce::study
