// Motion with one corner on the ground, as power series in time.
//
// The corner stays on the ground, so that y = -r_y(theta). With r' = omega (-r_y, r_x), forces per
// unit of mass, f_n = y'' - g_y and f_t = x'' - g_x, and r_g^2 omega' = r_x f_n - r_y f_t:
//
//   sticks:  the corner is a pivot and the square a pendulum,
//            omega' = (r_y g_x - r_x g_y) / (r_g^2 + rho^2),
//            f_n = -r_x omega' + r_y omega^2 - g_y,   f_t = r_y omega' + r_x omega^2 - g_x;
//   slides:  f_t = -sigma mu f_n,  and with e = r_x + sigma mu r_y
//            omega' = e (r_y omega^2 - g_y) / (r_g^2 + r_x e),   x'' = g_x - sigma mu f_n.
//            (r_g^2 + r_x e is r_g^2 (a - sigma mu b): no such motion where it is not positive.)
//
// Taylor's method: each right-hand side is made of sums, products and one quotient, so that the
// coefficients of all series follow from each other, order by order (Jorba & Zou 2005, "A software
// package for the numerical integration of ODEs by means of high-order Taylor methods"). The series
// are dense output at no further cost, and every guard below is a polynomial too.
//
// Guards are positive while the mode lasts: f_n; for sticking mu f_n - f_t and mu f_n + f_t; for
// sliding sigma v_t; and the heights of the two neighbouring corners, -r_y +- r_x.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "../methods/square.hpp"
#include "first_root.hpp"

namespace bounce::study {

inline constexpr int kMaxOrder = 28;

template <class Real>
using Series = Row<Real, kMaxOrder + 1>;

// Coefficient n of a product.
template <class Real>
Real product(const Series<Real>& f, const Series<Real>& g, int n) {
  Real sum = 0;
  for (int i = 0; i <= n; ++i) sum += f[i] * g[n - i];
  return sum;
}

template <class Real>
Real value(const Series<Real>& f, int order, Real t) {
  Real sum = f[order];
  for (int i = order - 1; i >= 0; --i) sum = sum * t + f[i];
  return sum;
}

// The first time in [0, end] at which a guard becomes negative, or infinity. A guard that is 0 at
// the start, as when a mode begins, counts only if it falls by at least `still` per second.
// Otherwise the search passes it, for as long as it is 0, by steps that double from 1e-12 s.
template <class Real>
Real first_fall(const Series<Real>& f, int order, Real end) {
  constexpr Real never = std::numeric_limits<Real>::infinity(), still = Real(1e-9);
  Real rest = 0, curvature = 0, power = 1;  // sum |f_i| end^i, sum i (i - 1) |f_i| end^(i-2)
  for (int i = 1; i <= order; ++i) {
    if (i >= 2) curvature += Real(i * (i - 1)) * std::abs(f[i]) * power;
    if (i >= 2) power *= end;
    rest += std::abs(f[i]) * power * end;
  }
  if (f[0] > rest) return never;
  const Real rounding = 8 * std::numeric_limits<Real>::epsilon() * (std::abs(f[0]) + rest);
  Real least = Real(1e-12);
  for (Real t = 0; t < end;) {
    Real g = f[order], slope = 0;
    for (int i = order - 1; i >= 0; --i) {
      slope = slope * t + g;
      g = g * t + f[i];
    }
    const bool falls = slope < -still;
    if (falls && g <= rounding - slope * 4 * std::numeric_limits<Real>::epsilon() * t) return t;
    const Real safe = safe_step(g, slope, curvature);
    if (!falls && g <= rounding && safe < least) {
      t += least;
      least *= 2;
    } else {
      t += safe;
    }
  }
  return never;
}

enum class Guard { none, lifts, stops_sliding, slips_right, slips_left, lands_left, lands_right };

template <class Real>
class CornerMotion {
 public:
  // sigma 0: the corner sticks; 1, -1: it slides right, left. s has its corner r on the ground.
  CornerMotion(const Body<Real>& body, const Motion<Real>& s, const Arm<Real>& r, int sigma,
               int order)
      : body_(body), sigma_(sigma), order_(order), corner_x_(s.x + r.x) {
    r_x_[0] = r.x;
    r_y_[0] = r.y;
    theta_[0] = s.theta;
    omega_[0] = s.omega;
    x_[0] = s.x;
    v_x_[0] = sigma ? s.v_x : r.y * s.omega;
    for (int n = 0; n <= order; ++n) sigma ? slide(n) : stick(n);
  }

  // The time for which the series hold to `tolerance`, in rad and in units of rho.
  Real reach(Real tolerance) const {
    Real shortest = std::numeric_limits<Real>::infinity();
    for (const int n : {order_ - 1, order_}) {
      const Real size = std::max(std::abs(theta_[n]), sigma_ ? std::abs(x_[n]) / body_.rho : 0);
      if (size > 0) shortest = std::min(shortest, std::pow(tolerance / size, 1 / Real(n)));
    }
    return shortest;
  }

  // The first guard to fall in [0, end], and when.
  std::pair<Guard, Real> first_guard(Real end) const {
    std::pair<Guard, Real> first{Guard::none, std::numeric_limits<Real>::infinity()};
    const auto watch = [&](Guard guard, auto coefficient) {
      Series<Real> f{};
      for (int n = 0; n < order_; ++n) f[n] = coefficient(n);
      const Real t = first_fall(f, order_ - 1, end);
      if (t < first.second) first = {guard, t};
    };
    watch(Guard::lands_right, [&](int n) { return r_x_[n] - r_y_[n]; });
    watch(Guard::lands_left, [&](int n) { return -r_x_[n] - r_y_[n]; });
    watch(Guard::lifts, [&](int n) { return f_n_[n]; });
    if (sigma_) {
      watch(Guard::stops_sliding, [&](int n) { return Real(sigma_) * v_t_[n]; });
    } else {
      watch(Guard::slips_left, [&](int n) { return body_.mu * f_n_[n] - f_t_[n]; });
      watch(Guard::slips_right, [&](int n) { return body_.mu * f_n_[n] + f_t_[n]; });
    }
    return first;
  }

  Motion<Real> at(Real t) const {
    const Real theta = value(theta_, order_, t), omega = value(omega_, order_, t);
    const Real r_x = value(r_x_, order_, t), r_y = value(r_y_, order_, t);
    const Real x = sigma_ ? value(x_, order_, t) : corner_x_ - r_x;
    const Real v_x = sigma_ ? value(v_x_, order_, t) : r_y * omega;
    return {x, -r_y, theta, v_x, -r_x * omega, omega};
  }

 private:
  // The part that both modes share, once omega' is known to order n: f_n, and the next orders.
  void advance(int n) {
    f_n_[n] = -product(r_x_, alpha_, n) + r_y_omega2_[n] - (n ? Real(0) : body_.g_y);
    if (n == order_) return;
    const Real next = 1 / Real(n + 1);
    r_x_[n + 1] = -product(r_y_, omega_, n) * next;
    r_y_[n + 1] = product(r_x_, omega_, n) * next;
    theta_[n + 1] = omega_[n] * next;
    omega_[n + 1] = alpha_[n] * next;
  }

  void squares(int n) {
    omega2_[n] = product(omega_, omega_, n);
    r_y_omega2_[n] = product(r_y_, omega2_, n);
  }

  void stick(int n) {
    squares(n);
    const Real inertia = body_.gyration_squared + body_.rho * body_.rho;
    alpha_[n] = (r_y_[n] * body_.g_x - r_x_[n] * body_.g_y) / inertia;
    f_t_[n] = product(r_y_, alpha_, n) + product(r_x_, omega2_, n) - (n ? Real(0) : body_.g_x);
    advance(n);
  }

  void slide(int n) {
    squares(n);
    const Real friction = Real(sigma_) * body_.mu;
    e_[n] = r_x_[n] + friction * r_y_[n];
    press_[n] = r_y_omega2_[n] - (n ? Real(0) : body_.g_y);
    inertia_[n] = product(r_x_, e_, n) + (n ? Real(0) : body_.gyration_squared);
    Real sum = product(e_, press_, n);
    for (int i = 1; i <= n; ++i) sum -= inertia_[i] * alpha_[n - i];
    alpha_[n] = sum / inertia_[0];
    v_t_[n] = v_x_[n] - product(r_y_, omega_, n);
    advance(n);
    if (n == order_) return;
    v_x_[n + 1] = ((n ? Real(0) : body_.g_x) - friction * f_n_[n]) / Real(n + 1);
    x_[n + 1] = v_x_[n] / Real(n + 1);
  }

  const Body<Real>& body_;
  int sigma_, order_;
  Real corner_x_;
  Series<Real> r_x_, r_y_, theta_, omega_, alpha_, omega2_, r_y_omega2_, f_n_;
  Series<Real> f_t_;                                  // sticking only
  Series<Real> x_, v_x_, v_t_, e_, press_, inertia_;  // sliding only
};

}  // namespace bounce::study
