// One corner with friction: the LCP of eq. (8) in closed form, by contact case.
//
// In impulses per unit of mass, p_n = dt f_n / m and p_t = dt (f_t2 - f_t1) / m, eq. (8) says: find
// p_n >= 0 and |p_t| <= mu p_n with
//
//     w   = a p_n + b p_t + u_n >= 0,   w p_n = 0,
//     v_t = b p_n + c p_t + u_t,        p_t = -mu p_n sign(v_t) where v_t is not 0,
//
// where u_n = J_n^T ((1 + epsilon) v + dt g) and u_t = J_t^T (v + dt g) are p of eq. (10).
//
//   Case 1, separates:    u_n >= 0:  p = 0.
//   Case 2, sticks:       w = v_t = 0:  p_n = N / D,  p_t = T / D  with  D = ac - b^2 > 0,
//                         N = b u_t - c u_n,  T = b u_n - a u_t.  It needs |T| <= mu N.
//   Case 3, slides right: p_t = -mu p_n:  p_n = -u_n / (a - mu b).  Then v_t = -(T + mu N) / (a -
//                         mu b), so that v_t > 0 is T < -mu N, where case 2 doesn't hold.
//   Case 4, slides left:  p_t = mu p_n:   p_n = -u_n / (a + mu b), for T > mu N.
//
// For a > mu |b| exactly one case holds (Lotstedt 1981, "Coulomb friction in two-dimensional rigid
// body systems", ZAMM 61). Cases 3 and 4 exclude each other, since together they need N < 0 and
// b^2 > ac. Otherwise there may be two more solutions: Painleve's paradox in velocities. There is
// always at least one (Stewart & Trinkle 1996, theorem 3.1).
//
// One division is enough for all cases, and the tests need none, so that this form is also fast. It
// avoids max(0, NaN), so that a NaN stays NaN.
#pragma once

#include <cmath>

#include "square.hpp"

namespace bounce::study {

template <class Real>
struct OneCorner {
  Real a, b, c;   // no unit
  Real u_n, u_t;  // m/s
  Real mu;
};

enum class ContactMode { separates, sticks, slides_right, slides_left };

template <class Real>
struct CornerImpulse {
  Real n, t;  // p_n and p_t, m/s
  ContactMode mode;
};

template <class Real>
OneCorner<Real> one_corner(const Arm<Real>& r, Real gyration_squared, Real u_n, Real u_t, Real mu) {
  return {1 + r.x * r.x / gyration_squared,
          -r.x * r.y / gyration_squared,
          1 + r.y * r.y / gyration_squared,
          u_n,
          u_t,
          mu};
}

// The corner of a rectangle that leans alpha from the vertical below the centre, rad. Its distance
// from there is 1 m; then r_g^2 = 1/3 m^2, whatever the sides.
inline OneCorner<double> leaning_corner(double alpha, double u_n, double u_t, double mu) {
  return one_corner<double>({std::sin(alpha), -std::cos(alpha)}, 1.0 / 3, u_n, u_t, mu);
}

// sigma: 0 if the corner sticks, else the direction in which it slides.
inline ContactMode mode_of(int sigma) {
  if (sigma == 0) return ContactMode::sticks;
  return sigma > 0 ? ContactMode::slides_right : ContactMode::slides_left;
}

template <class Real>
CornerImpulse<Real> sliding_impulse(const OneCorner<Real>& k, int sigma) {
  const Real n = -k.u_n / (k.a - sigma * k.mu * k.b);
  return {n, -sigma * k.mu * n, mode_of(sigma)};
}

// The solution if a > mu |b|; else one of several, or with a - sigma mu b = 0 no finite number. NaN
// in gives NaN out.
template <class Real>
CornerImpulse<Real> solve_one_corner(const OneCorner<Real>& k) {
  if (k.u_n >= 0) return {0, 0, ContactMode::separates};
  const Real N = k.b * k.u_t - k.c * k.u_n, T = k.b * k.u_n - k.a * k.u_t;
  if (std::abs(T) <= k.mu * N) {
    const Real D = k.a * k.c - k.b * k.b;
    return {N / D, T / D, ContactMode::sticks};
  }
  return sliding_impulse(k, T < 0 ? 1 : -1);
}

// All solutions. For a > mu |b| there is one.
inline std::vector<CornerImpulse<double>> all_solutions(const OneCorner<double>& k) {
  std::vector<CornerImpulse<double>> found;
  if (k.u_n >= 0) found.push_back({0, 0, ContactMode::separates});
  const double D = k.a * k.c - k.b * k.b;
  const double N = k.b * k.u_t - k.c * k.u_n, T = k.b * k.u_n - k.a * k.u_t;
  if (N > 0 && std::abs(T) <= k.mu * N) found.push_back({N / D, T / D, ContactMode::sticks});
  for (const int sigma : {1, -1}) {
    const auto p = sliding_impulse(k, sigma);
    const double v_t = k.u_t + (k.b - sigma * k.mu * k.c) * p.n;
    if (p.n > 0 && sigma * v_t > 0) found.push_back(p);
  }
  return found;
}

}  // namespace bounce::study
