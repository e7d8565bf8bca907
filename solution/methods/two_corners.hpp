// Two corners with friction, their friction rows merged: the LCP in closed form.
//
// Two corners touch at once only where a side lies on the ground, or nearly so. Then r_y is one
// number for both, J_t is one column, and only the sum of the two friction impulses has a meaning:
// two sets of friction rows, as in the 8x8, make the matrix singular at theta = 0 and nearly so at
// theta = 1e-12. Merged, with P = p_1 + p_2, and u_i and u_t the rows' values without impulses (u_n
// and u_t of one_corner.hpp):
//
//     w_i = sum_j A_ij p_j + b_i p_t + u_i >= 0,   p_i >= 0,   w_i p_i = 0,     i = 1, 2
//     v_t = b_1 p_1 + b_2 p_2 + c p_t + u_t,       |p_t| <= mu P,
//     p_t = -sigma mu P where sigma = sign(v_t) is not 0,
//
//     A_ij = 1 + r_ix r_jx / r_g^2,   b_i = -r_ix r_y / r_g^2,   c = 1 + r_y^2 / r_g^2.
//
// The rows are those of impulses with Coulomb friction in the plane (Lotstedt 1981; Stewart &
// Trinkle 1996, "An implicit time-stepping scheme for rigid body dynamics with inelastic collisions
// and Coulomb friction", Int. J. Numer. Meth. Eng. 39). Each friction case leaves an LCP of 2x2 for
// p_1 and p_2:
//
//   sticks:  p_t = -(b_1 p_1 + b_2 p_2 + u_t) / c:   B_ij = A_ij - b_i b_j / c,
//                                                    u'_i = u_i - b_i u_t / c
//   slides:  p_t = -sigma mu P:                      B_ij = A_ij - sigma mu b_i,  u'_i = u_i
//
// and that has four cases: none, 1, 2, or both corners pressed, its complementary cones (Murty
// 1988, "Linear complementarity, linear and nonlinear programming", section 1.3). Twelve cases in
// all; the first without a violated inequality is the solution, and where rounding leaves none, the
// one violated least is. Impulses per unit of mass and velocities have one unit, so that "least"
// has a meaning.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "square.hpp"

namespace bounce::study {

// By how much x violates x >= 0; infinite for NaN, which std::max would hide.
template <class Real>
Real lack(Real x) {
  if (x >= 0) return 0;
  return x < 0 ? -x : std::numeric_limits<Real>::infinity();
}

// What a friction case leaves: B and u'.
template <class Real>
struct TwoByTwo {
  Real B[2][2], u[2];

  // p_1 and p_2 with the corners of `pressed` (bit i for corner i) pressed.
  Row<Real, 2> impulses(int pressed) const {
    if (pressed == 0) return {0, 0};
    if (pressed == 1) return {-u[0] / B[0][0], 0};
    if (pressed == 2) return {0, -u[1] / B[1][1]};
    const Real D = B[0][0] * B[1][1] - B[0][1] * B[1][0];
    return {(B[0][1] * u[1] - B[1][1] * u[0]) / D, (B[1][0] * u[0] - B[0][0] * u[1]) / D};
  }

  Real violation(const Row<Real, 2>& p) const {
    Real worst = 0;
    for (int i = 0; i < 2; ++i) {
      const Real w = B[i][0] * p[0] + B[i][1] * p[1] + u[i];
      worst = std::max({worst, lack(p[i]), p[i] == 0 ? lack(w) : Real(0)});
    }
    return worst;
  }
};

template <class Real>
struct TwoCorners {
  Row<Real, 2> r_x;            // m
  Real r_y, gyration_squared;  // m, m^2
  Row<Real, 2> u;              // u_1, u_2, m/s
  Real u_t, mu;                // m/s, none

  Real A(int i, int j) const { return 1 + r_x[i] * r_x[j] / gyration_squared; }
  Real b(int i) const { return -r_x[i] * r_y / gyration_squared; }
  Real c() const { return 1 + r_y * r_y / gyration_squared; }

  // sigma: the direction of sliding, or 0 if the side sticks.
  TwoByTwo<Real> with_friction(int sigma) const {
    TwoByTwo<Real> lcp;
    for (int i = 0; i < 2; ++i) {
      for (int j = 0; j < 2; ++j)
        lcp.B[i][j] = A(i, j) - (sigma ? sigma * mu * b(i) : b(i) * b(j) / c());
      lcp.u[i] = u[i] - (sigma ? 0 : b(i) * u_t / c());
    }
    return lcp;
  }
};

template <class Real>
struct SideImpulse {
  Row<Real, 2> n;  // p_1, p_2, m/s
  Real t;          // p_t of both together, m/s
  Real violation;  // of the worst inequality, m/s; 0 but for rounding
};

// The side's problem from its two arms; r_y is their mean.
template <class Real>
TwoCorners<Real> two_corners(const Arm<Real>& r_1, const Arm<Real>& r_2, Real gyration_squared,
                             Row<Real, 2> u, Real u_t, Real mu) {
  return {{r_1.x, r_2.x}, (r_1.y + r_2.y) / 2, gyration_squared, u, u_t, mu};
}

template <class Real>
void push_side(Motion<Real>& s, const Arm<Real>& r_1, const Arm<Real>& r_2,
               const SideImpulse<Real>& p, Real gyration_squared) {
  s.v_x += p.t;
  s.v_y += p.n[0] + p.n[1];
  s.omega += (r_1.x * p.n[0] + r_2.x * p.n[1] - (r_1.y + r_2.y) / 2 * p.t) / gyration_squared;
}

// The impulses with friction in a given direction: sigma 0 sticks, 1 slides right, -1 left. The
// violation counts the normal rows, and with `checked` the friction's.
template <class Real>
SideImpulse<Real> solve_side(const TwoCorners<Real>& k, int sigma, bool checked) {
  const TwoByTwo<Real> lcp = k.with_friction(sigma);
  SideImpulse<Real> best{{0, 0}, 0, std::numeric_limits<Real>::infinity()};
  for (const int pressed : {3, 0, 1, 2}) {
    const Row<Real, 2> p = lcp.impulses(pressed);
    const Real P = p[0] + p[1], coupled = k.b(0) * p[0] + k.b(1) * p[1] + k.u_t;
    const Real p_t = sigma ? -sigma * k.mu * P : -coupled / k.c();
    Real violation = lcp.violation(p);
    if (checked) {
      violation = std::max(
          violation, lack(sigma ? sigma * (coupled + k.c() * p_t) : k.mu * P - std::abs(p_t)));
    }
    if (violation < best.violation) best = {p, p_t, violation};
    if (violation <= 0) break;
  }
  return best;
}

template <class Real>
SideImpulse<Real> solve_two_corners(const TwoCorners<Real>& k) {
  SideImpulse<Real> best{{0, 0}, 0, std::numeric_limits<Real>::infinity()};
  for (const int sigma : {0, 1, -1}) {
    const SideImpulse<Real> found = solve_side(k, sigma, true);
    if (found.violation < best.violation) best = found;
    if (found.violation <= 0) break;
  }
  return best;
}

}  // namespace bounce::study
