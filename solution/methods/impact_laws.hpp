// Three laws of impact with friction for one corner: Newton, Poisson and Stronge.
//
// Newton: v_n after = -epsilon v_n before, and Coulomb's law between the impulses and the velocity
// after: the LCP of eq. (8). With friction it can gain energy (Kane & Levinson 1985, Dynamics,
// section 5.8). Stick is the worst: with x = (v_t, v_n) of the corner, its share of the energy is
// x^T G^-1 x / 2 with G = [c b; b a]; before it is at least (c - b^2 / a) v_n^2 / 2 D whatever v_t,
// after it is c epsilon^2 v_n^2 / 2 D. So a gain needs
//
//     epsilon > sqrt(1 - b^2 / (a c)),
//
// and enough friction; see gain_limit().
//
// Poisson and Stronge follow the impact (Routh 1860; Keller 1986, "Impact with friction", J. Appl.
// Mech. 53). With P, the normal impulse so far, as the time,
//
//     slides, sigma = sign v_t:  dv_t/dP = b - sigma mu c,   dv_n/dP = a - sigma mu b,
//     sticks, if |b| <= mu c:    dv_t/dP = 0,                dv_n/dP = a - b^2 / c,
//     else it slips on, with sigma = sign b.
//
// Compression ends at P_c, where v_n = 0. Poisson's restitution gives P = (1 + epsilon) P_c.
// Stronge's (1990, "Rigid body collisions with friction", Proc. R. Soc. A 431) ends where the
// normal force has given back epsilon^2 of the work that it took, W = integral of v_n dP. Friction
// opposes sliding at every moment here, and neither law gains energy.
#pragma once

#include <algorithm>
#include <limits>

#include "one_corner.hpp"

namespace bounce::study {

enum class ImpactLaw { newton, poisson, stronge };

template <class Real>
struct Collision {
  Real a, b, c;
  Real v_n, v_t;  // of the corner before, m/s; v_n < 0
  Real mu, epsilon;
};

template <class Real>
Collision<Real> collision_of(const Motion<Real>& s, const Arm<Real>& r, const Body<Real>& body) {
  const auto k = one_corner<Real>(r, body.gyration_squared, 0, 0, body.mu);
  return {k.a, k.b, k.c, normal_velocity(s, r), tangential_velocity(s, r), body.mu, body.epsilon};
}

// The impulse of an impact by Newton's law; 0 if the corner does not approach.
template <class Real>
CornerImpulse<Real> newton_impact(const Collision<Real>& k) {
  if (k.v_n >= 0) return {0, 0, ContactMode::separates};
  return solve_one_corner<Real>({k.a, k.b, k.c, (1 + k.epsilon) * k.v_n, k.v_t, k.mu});
}

namespace detail {

// How the corner moves with P while it slides in direction sigma (0: it sticks).
struct Slopes {
  double n, t;      // dv_n/dP, dv_t/dP
  double friction;  // dp_t/dP
};

inline Slopes slopes(const Collision<double>& k, int sigma) {
  const double friction = sigma == 0 ? -k.b / k.c : -sigma * k.mu;
  return {k.a + k.b * friction, sigma == 0 ? 0 : k.b + k.c * friction, friction};
}

inline int direction(const Collision<double>& k, double v_t) {
  if (v_t != 0) return v_t > 0 ? 1 : -1;
  if (std::abs(k.b) <= k.mu * k.c) return 0;
  return k.b > 0 ? 1 : -1;
}

// Integrates Routh's impact over P, from one change of the friction case to the next, for Poisson's
// or Stronge's law.
inline CornerImpulse<double> follow_impact(const Collision<double>& k, ImpactLaw law) {
  constexpr double never = std::numeric_limits<double>::infinity();
  double v_n = k.v_n, v_t = k.v_t, P = 0, p_t = 0, work = 0, last = 0, wanted = 0;
  bool compresses = true;
  for (int stage = 0; stage < 6; ++stage) {
    const Slopes slope = slopes(k, direction(k, v_t));
    const double to_stop = slope.t * v_t < 0 ? -v_t / slope.t : never;
    double to_end = never;
    if (compresses) {
      if (slope.n > 0) to_end = -v_n / slope.n;
    } else if (law == ImpactLaw::poisson) {
      to_end = last - P;
    } else {  // v_n s + slope s^2 / 2 = the work still to be given back
      const double root = std::sqrt(std::max(v_n * v_n + 2 * slope.n * (wanted - work), 0.0));
      to_end = v_n + root > 0 ? 2 * (wanted - work) / (v_n + root) : 0;
    }
    const double s = std::min(to_stop, to_end);
    work += (v_n + slope.n * s / 2) * s;
    v_n += slope.n * s;
    v_t = s == to_stop ? 0 : v_t + slope.t * s;
    P += s;
    p_t += slope.friction * s;
    if (to_end > to_stop) continue;
    if (!compresses) break;
    compresses = false;
    v_n = 0;
    last = (1 + k.epsilon) * P;
    wanted = work * (1 - k.epsilon * k.epsilon);
  }
  return {P, p_t, mode_of(direction(k, v_t))};
}

}  // namespace detail

inline CornerImpulse<double> impact(const Collision<double>& k, ImpactLaw law) {
  if (k.v_n >= 0 || law == ImpactLaw::newton) return newton_impact(k);
  return detail::follow_impact(k, law);
}

// The change of energy per unit of mass, J/kg: p^T (v before + v after) / 2.
inline double energy_gained(const Collision<double>& k, const CornerImpulse<double>& p) {
  const double v_n = k.v_n + k.a * p.n + k.b * p.t, v_t = k.v_t + k.b * p.n + k.c * p.t;
  return (p.n * (k.v_n + v_n) + p.t * (k.v_t + v_t)) / 2;
}

// The value of epsilon above which Newton's law can gain energy at a corner with these a, b, c, for
// some velocity; 1 without friction, or with b = 0. With v_n = -1 and b > 0 (mirror it otherwise)
// the gain is largest at v_t = -b / a, where p_t / p_n = -epsilon b / (c (1 + epsilon) - b^2 / a)
// if it sticks: the square root above. With less friction it is largest at the edge of sticking,
// v_t after = 0 with p_t = -mu p_n, where 2 gain / p_n = mu (b - mu c) p_n - (1 - epsilon) with p_n
// = (1 + epsilon) / (a - mu b).
inline double gain_limit(double a, double b, double c, double mu) {
  const double coupling = std::abs(b);
  const double stuck = std::sqrt(1 - coupling * coupling / (a * c));
  if (mu * (c * (1 + stuck) - coupling * coupling / a) >= stuck * coupling) return stuck;
  const double k = mu * (coupling - mu * c) / (a - mu * coupling);  // k (1 + epsilon) > 1 - epsilon
  return (1 - k) / (1 + k);
}

}  // namespace bounce::study
