// The square and its corners, for every method of the study. Real is double, or long double where
// the truth is checked in a second precision.
//
// With r = corner - centre, in the world frame, the velocity of a corner is (eq. 6)
//
//     v_t = J_t^T v = v_x - r_y omega,       v_n = J_n^T v = v_y + r_x omega,
//
// and an impulse m (p_t, p_n) at that corner changes the body's velocity by
//
//     M^-1 (J_t p_t + J_n p_n) m = (p_t, p_n, (r_x p_n - r_y p_t) / r_g^2).
//
// Impulses are per unit of mass here, in m/s, so that the mass falls out of every contact problem,
// and no method has to mix numbers of the size of m with numbers of the size of 1/m:
//
//     a = m J_n^T M^-1 J_n = 1 + r_x^2 / r_g^2,    b = m J_n^T M^-1 J_t = -r_x r_y / r_g^2,
//     c = m J_t^T M^-1 J_t = 1 + r_y^2 / r_g^2.
#pragma once

#include <bounce/types.hpp>
#include <cmath>
#include <vector>

namespace bounce::study {

// A fixed-size array with an int index.
template <class T, int n>
struct Row {
  T items[n];
  constexpr T& operator[](int i) { return items[i]; }
  constexpr const T& operator[](int i) const { return items[i]; }
  constexpr const T* begin() const { return items; }
  constexpr const T* end() const { return items + n; }
  constexpr T* begin() { return items; }
  constexpr T* end() { return items + n; }
};

// The square without its mass, which no motion depends on. g(2) of the parameters has to be 0.
template <class Real>
struct Body {
  Real half;              // l / 2, m
  Real rho;               // from the centre to a corner, l / sqrt 2, m
  Real gyration_squared;  // r_g^2 = l^2 / 6, m^2
  Real mu;                // friction
  Real epsilon;           // restitution
  Real g_x, g_y;          // gravity, m/s^2

  explicit Body(const Parameters& params)
      : half(Real(params.l) / 2),
        rho(half * std::sqrt(Real(2))),
        gyration_squared(Real(params.l) * Real(params.l) / 6),
        mu(Real(params.mu)),
        epsilon(Real(params.epsilon)),
        g_x(Real(params.g.x())),
        g_y(Real(params.g.y())) {}
};

template <class Real>
struct Motion {
  Real x, y, theta;      // m, m, rad
  Real v_x, v_y, omega;  // m/s, m/s, rad/s
};
using Motions = std::vector<Motion<double>>;

template <class Real>
struct Arm {
  Real x, y;  // r, m
};

template <class Real = double>
Motion<Real> motion_of(const State& state) {
  return {Real(state.q(0)), Real(state.q(1)), Real(state.q(2)),
          Real(state.v(0)), Real(state.v(1)), Real(state.v(2))};
}

template <class Real>
State state_of(const Motion<Real>& s) {
  return {{double(s.x), double(s.y), double(s.theta)},
          {double(s.v_x), double(s.v_y), double(s.omega)}};
}

// The four arms, counted as in eq. (3): each is the one before, turned by a right angle.
template <class Real>
Row<Arm<Real>, 4> arms(Real half, Real cosine, Real sine) {
  const Real p = half * (cosine + sine), q = half * (cosine - sine);
  return {{{q, p}, {-p, q}, {-q, -p}, {p, -q}}};
}

template <class Real>
Row<Arm<Real>, 4> arms(const Body<Real>& body, Real theta) {
  return arms(body.half, std::cos(theta), std::sin(theta));
}

// The lowest arm, found without a search: the four differ by right angles, so that r_y = -(|cos| +
// |sin|) l / 2, and the signs of r_x follow.
template <class Real>
Arm<Real> lowest_arm(Real half, Real cosine, Real sine) {
  return {half * (std::copysign(Real(1), cosine) * sine - std::copysign(Real(1), sine) * cosine),
          -half * (std::abs(cosine) + std::abs(sine))};
}

// The height of the centre where the lowest corner touches the ground, m.
template <class Real>
Real height_on_ground(Real half, Real theta) {
  return half * (std::abs(std::cos(theta)) + std::abs(std::sin(theta)));
}

template <class Real>
Real normal_velocity(const Motion<Real>& s, const Arm<Real>& r) {
  return s.v_y + r.x * s.omega;
}

template <class Real>
Real tangential_velocity(const Motion<Real>& s, const Arm<Real>& r) {
  return s.v_x - r.y * s.omega;
}

// Adds the impulse m (p_t t + p_n n) at the corner whose arm is r; p_n and p_t in m/s.
template <class Real>
void apply_impulse(Motion<Real>& s, const Arm<Real>& r, Real p_n, Real p_t, Real gyration_squared) {
  s.v_x += p_t;
  s.v_y += p_n;
  s.omega += (r.x * p_n - r.y * p_t) / gyration_squared;
}

// Energy per unit of mass, J/kg.
template <class Real>
Real energy(const Motion<Real>& s, const Body<Real>& body) {
  return (s.v_x * s.v_x + s.v_y * s.v_y + body.gyration_squared * s.omega * s.omega) / 2 -
         body.g_x * s.x - body.g_y * s.y;
}

// The height of the lowest corner, m: phi of eq. (4).
template <class Real>
Real lowest_gap(const Motion<Real>& s, const Body<Real>& body) {
  return s.y - height_on_ground(body.half, s.theta);
}

}  // namespace bounce::study
