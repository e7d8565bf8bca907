// Finds the first root of a function that falls to 0, and misses none before it.
//
// With f(t) >= 0 and f'' >= -K from t on, f(t + s) >= f + f' s - K s^2 / 2, so that nothing happens
// before the positive root of that parabola,
//
//     s = (f' + sqrt(f'^2 + 2 K f)) / K = 2 f / (sqrt(f'^2 + 2 K f) - f').
//
// Stepping from bound to bound comes to the first root from below and never passes one. At a simple
// root it converges as Newton's method does. At a double root, where f'' > 0, each step leaves
// s / (1 + s) of the distance, with s = sqrt(1 + K / f'').
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace bounce::study {

// A step in which there is certainly no root.
template <class Real>
Real safe_step(Real f, Real slope, Real K) {
  f = std::max(f, Real(0));
  const Real root = std::sqrt(slope * slope + 2 * K * f);
  if (slope < 0) return 2 * f / (root - slope);
  return K > 0 ? (slope + root) / K : std::numeric_limits<Real>::infinity();
}

}  // namespace bounce::study
