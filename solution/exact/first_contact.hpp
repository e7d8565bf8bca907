// Free flight, and when it ends: the first contact of any corner, guaranteed.
//
// In flight the centre moves on a parabola and theta grows evenly, so that the height of corner k
//
//     f_k(t) = y(t) + r_ky(t),   f_k' = v_n of the corner,   f_k'' = g_y - r_ky omega^2 >= -K,
//     K = max(-g_y, 0) + rho omega^2,
//
// is known exactly with its slope and a bound of its curvature: see first_root.hpp. While y > rho,
// no corner can touch, whatever theta: that part of the flight is a leg of its own, in closed form.
// At its end y is set to rho exactly: computed, it would be off by the rounding of the height from
// which the square fell.
#pragma once

#include <limits>

#include "../methods/square.hpp"
#include "first_root.hpp"

namespace bounce::study {

template <class Real>
Motion<Real> fly(const Motion<Real>& s, const Body<Real>& body, Real t) {
  return {s.x + t * (s.v_x + body.g_x * t / 2),
          s.y + t * (s.v_y + body.g_y * t / 2),
          s.theta + s.omega * t,
          s.v_x + body.g_x * t,
          s.v_y + body.g_y * t,
          s.omega};
}

// The time until y has fallen to rho: 0 if it is below, infinite if it never does.
template <class Real>
Real time_above(const Motion<Real>& s, const Body<Real>& body) {
  const Real height = s.y - body.rho;
  if (height <= 0) return 0;
  if (body.g_y < 0) return safe_step(height, s.v_y, -body.g_y);
  // Gravity that pulls up, or none: the parabola has its least height at v_y + g_y t = 0.
  const Real square = s.v_y * s.v_y - 2 * body.g_y * height;
  if (s.v_y >= 0 || square < 0) return std::numeric_limits<Real>::infinity();
  return 2 * height / (-s.v_y + std::sqrt(square));
}

// How long a flight near the ground lasts, and whether it ends with a contact or above y = rho.
template <class Real>
struct NearFlight {
  Real time;
  bool contact;
};

// Follows a flight with y <= rho to its first contact, a corner at height 0 that comes down; or to
// where y > rho; or to t_end. A corner at 0 that does not come down has just left the ground,
// perhaps without velocity yet. The search passes it by steps that double from 1e-10, each so short
// that nothing sinks by 1e-14. Units are the body's: its size and g are near 1.
template <class Real>
NearFlight<Real> first_contact(const Motion<Real>& start, const Body<Real>& body, Real t_end) {
  const Real K = std::max(-body.g_y, Real(0)) + body.rho * start.omega * start.omega;
  const Real resting = Real(1e-12), epsilon = std::numeric_limits<Real>::epsilon();
  const Real rounding = 4 * epsilon * body.rho;  // a height this near 0 counts as 0
  const Real longest = std::sqrt(2 * Real(1e-14) / std::max(K, Real(1e-3)));
  Real least = std::min(Real(1e-10), longest);
  for (Real t = 0; t < t_end;) {
    const Motion<Real> s = fly(start, body, t);
    if (s.y > body.rho && t > 0) return {t, false};
    const Real of_time = 4 * epsilon * t;  // rounding of t
    Real step = t_end - t;
    bool passes = false;
    for (const Arm<Real>& r : arms(body, s.theta)) {
      const Real f = s.y + r.y, slope = normal_velocity(s, r);
      const bool falls = slope < -resting;
      if (falls && f <= rounding - slope * of_time) return {t, true};
      const Real safe = safe_step(f, slope, K);
      if (!falls && safe < least) {
        step = std::min(step, least);
        passes = true;
      } else {
        step = std::min(step, safe);
      }
    }
    if (passes) least = std::min(2 * least, longest);
    t += step;
  }
  return {t_end, false};
}

}  // namespace bounce::study
