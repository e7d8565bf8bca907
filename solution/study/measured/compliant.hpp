// A compliant corner: a spring and a damper along the normal, a spring along the tangent whose
// force Coulomb's law bounds (Maw, Barber & Fawcett 1976, "The oblique impact of elastic spheres",
// Wear 38; with lumped springs Stronge 2000, "Impact mechanics", chapter 5).
//
//     f_n = max(0, depth + 2 zeta depth' / sqrt(a)),    |f_t| <= mu f_n,    f_t = -kappa stretch,
//     v_n' = a f_n + b f_t,    v_t' = b f_n + c f_t,    depth' = -v_n,    stretch' = v_t,
//
// in units in which the normal stiffness per mass is 1; the impulse doesn't depend on it, because
// the square doesn't turn during an impact. While |f_t| is at its bound, the corner slides and the
// stretch stays the same. zeta is chosen so that a corner with b = 0 rebounds with epsilon.
#pragma once

#include <algorithm>
#include <cmath>

#include "methods/impact_laws.hpp"
#include "methods/penalty.hpp"

namespace bounce::study {

inline constexpr int kStepsPerCompression = 24;

// zeta: damping ratio of the normal spring, in place of k.epsilon; kappa: tangential stiffness over
// the normal one. The friction case of the result has no meaning.
inline CornerImpulse<double> compliant_impact(const Collision<double>& k, double zeta,
                                              double kappa) {
  const double root = std::sqrt(k.a), quarter = std::acos(-1.0) / 2;
  const double fastest = std::sqrt(std::max(k.a, kappa * k.c));
  const double h = quarter / fastest / kStepsPerCompression;
  const double longest = 8 * quarter / root;  // four free compressions
  double v_n = k.v_n, v_t = k.v_t, depth = 0, stretch = 0, p_n = 0, p_t = 0;
  for (double t = 0; t < longest; t += h) {
    const double f_n = std::max(0.0, depth - 2 * zeta / root * v_n);
    const double most = k.mu * f_n;
    const double f_t = std::clamp(-kappa * stretch, -most, most);
    if (kappa > 0) stretch = -f_t / kappa;
    p_n += h * f_n;
    p_t += h * f_t;
    v_n += h * (k.a * f_n + k.b * f_t);
    v_t += h * (k.b * f_n + k.c * f_t);
    depth -= h * v_n;
    stretch += h * v_t;
    if (v_n > 0 && (depth <= 0 || depth * root < 2 * zeta * v_n)) break;
  }
  return {p_n, p_t, ContactMode::separates};
}

}  // namespace bounce::study
