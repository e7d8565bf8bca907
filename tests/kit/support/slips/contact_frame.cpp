// All parts in one more style: the square's own axes, the contact's two directions, and impulses.
#include <algorithm>
#include <array>
#include <bounce/part1_contacts.hpp>
#include <bounce/part3_step.hpp>
#include <cmath>
#include <numbers>

#include "whole_styles.hpp"

namespace slips {
namespace {

using std::numbers::pi;
using Pair = Eigen::Vector2d;  // along the ground and upwards

double sign(double x) { return x < 0 ? -1 : 1; }

double turn(const Vector3& q) {
  double theta = q(2);
  if (slip("theta taken as degrees, turned to radians")) theta *= pi / 180;
  if (slip("theta turned to degrees")) theta *= 180 / pi;
  if (slip("q(0) as the angle")) theta = q(0);
  if (slip("theta unused")) theta = 0;
  if (slip("theta turns the wrong way")) theta = -theta;
  if (slip("theta modulo 2 pi without its sign")) theta = std::fabs(std::fmod(theta, 2 * pi));
  if (slip("theta modulo 2 * 3.14")) theta = std::fmod(theta, 6.28);
  if (slip("theta is a float")) theta = static_cast<float>(theta);
  return theta;
}

// The lowest corner is half a side down each of the square's two axes.
Pair lowest_corner(double theta, double half) {
  double c = std::cos(theta), s = std::sin(theta);
  if (slip("c = 1, s = theta")) {
    c = 1;
    s = theta;
  }
  if (slip("sine and cosine exchanged")) std::swap(c, s);
  const Pair ahead(c, s), aside(-s, c);
  if (slip("highest corner")) return half * (sign(s) * ahead + sign(c) * aside);
  if (slip("always corner 1")) return half * (ahead + aside);
  if (slip("always corner 2")) return half * (aside - ahead);
  if (slip("always corner 3")) return -half * (ahead + aside);
  if (slip("always corner 4")) return half * (ahead - aside);
  if (slip("lower two corners alone")) return half * (-sign(s) * ahead - aside);
  if (slip("upper two corners alone")) return half * (-sign(s) * ahead + aside);
  return half * (-sign(s) * ahead - sign(c) * aside);
}

double height(const Vector3& q, const Pair& r, const Parameters& params) {
  const double half = params.l / 2;
  if (slip("phi = q(1)")) return q(1);
  if (slip("phi = y - l/2")) return q(1) - half;
  if (slip("phi = y - half diagonal")) return q(1) - std::sqrt(2) * half;
  if (slip("phi clamped at 0")) return std::max(0.0, q(1) + r.y());
  if (slip("phi with the other sign")) return -q(1) - r.y();
  if (slip("absolute value of phi")) return std::fabs(q(1) + r.y());
  if (slip("phi = r_y, centre forgotten")) return r.y();
  if (slip("x of the corner as phi")) return q(0) + r.x();
  return q(1) + r.y();
}

Contact touching(const Vector3& q, const Parameters& given) {
  const Parameters params = with_parameter_slips(given, "l");
  const double half = slip("half diagonal is l")       ? params.l / std::sqrt(2)
                      : slip("half diagonal is l / 2") ? params.l / std::sqrt(8)
                                                       : params.l / 2;
  Pair r = lowest_corner(turn(q), half);
  const double phi = height(q, r, params);
  if (slip("r from the world's origin")) r += q.head<2>();
  if (slip("r from the corner to the centre")) r = -r;
  Jacobian J;
  J << 1, 0, 0, 1, -r.y(), r.x();
  if (slip("J_t = (-1, 0, r_y)")) J.col(0) = -J.col(0);
  if (slip("J_n = (0, -1, -r_x)")) J.col(1) = -J.col(1);
  if (slip("sign of r_y in J_t")) J(2, 0) = -J(2, 0);
  if (slip("sign of r_x in J_n")) J(2, 1) = -J(2, 1);
  if (slip("columns exchanged, [J_n J_t]")) J.col(0).swap(J.col(1));
  if (slip("r_x and r_y exchanged in J")) J.row(2) << -r.x(), r.y();
  return {J, phi};
}

// --- part 2: the answers of the contact's directions to one another ---

Vector3 masses(const Parameters& P) {
  double r_g_squared = P.l * P.l / 6;
  if (slip("inertia l^2/3")) r_g_squared *= 2;
  if (slip("inertia l^2/8, a disc")) r_g_squared *= 0.75;
  if (slip("inertia l^2/12")) r_g_squared /= 2;
  if (slip("inertia of a point, m l^2")) r_g_squared *= 6;
  return {P.m, P.m, P.m * r_g_squared};
}

using Directions = std::array<Vector3, 3>;

Directions directions(const Jacobian& J) {
  const Vector3 t = J.col(0), n = J.col(1);
  if (slip("J_hat = [J_n J_t J_t]")) return {n, t, t};
  if (slip("J_hat = [J_n J_t -J_t]")) return {n, t, -t};
  return {n, -t, t};
}

Eigen::Matrix4d responses(const Jacobian& J, const Parameters& P) {
  const Vector3 M = masses(P);
  Vector3 mobility = M.cwiseInverse();
  if (slip("M in place of its inverse in V")) mobility = M;
  if (slip("inverse of M left out of V")) mobility.setOnes();
  const double dt = slip("dt left out of V") ? 1 : slip("dt^2 in V") ? P.dt * P.dt : P.dt;
  const Directions along = directions(J);
  Eigen::Matrix4d V = Eigen::Matrix4d::Zero();
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) V(i, k) = dt * along[i].dot(mobility.cwiseProduct(along[k]));
  if (slip("V all negative")) V = -V;
  V.col(3) << 0, 1, 1, 0;
  if (slip("last column 1 1 0 0")) V.col(3) << 1, 1, 0, 0;
  if (slip("last column 0 -1 -1 0")) V.col(3) << 0, -1, -1, 0;
  if (slip("last column zero")) V.col(3).setZero();
  V.row(3) << P.mu, -1, -1, V(3, 3);
  if (slip("last row mu 1 1 0")) V.row(3) << P.mu, 1, 1, 0;
  if (slip("last row 1 -1 -1 0")) V.row(3) << 1, -1, -1, 0;
  if (slip("last row 1 -mu -mu 0")) V.row(3) << 1, -P.mu, -P.mu, 0;
  if (slip("last row 0 -1 -1 0")) V.row(3) << 0, -1, -1, 0;
  return V;
}

Eigen::Vector4d rates(const Jacobian& J, const Vector3& v, const Parameters& P) {
  const Vector3 M = masses(P);
  Vector3 a = P.g;
  if (slip("M in place of its inverse in p")) a = M.cwiseAbs2().cwiseProduct(P.g);
  if (slip("inverse of M left out of p")) a = M.cwiseProduct(P.g);
  if (slip("f_e = 0")) a.setZero();
  const double dt = slip("dt^2 in p") ? P.dt * P.dt : slip("dt left out of p") ? 1 : P.dt;
  const Pair before = J.transpose() * v, gained = dt * J.transpose() * a;
  const double e = 1 + P.epsilon;
  double along = before(0) + gained(0), up = e * before(1) + gained(1);
  if (slip("1 + epsilon in every row, gravity too")) {
    along *= e;
    up = e * (before(1) + gained(1));
  }
  if (slip("1 + epsilon in the tangential rows")) along = e * before(0) + gained(0);
  if (slip("1 + epsilon on gravity too")) up = e * (before(1) + gained(1));
  if (slip("1 + epsilon only for what approaches") && before(1) > 0) up = before(1) + gained(1);
  if (slip("no gravity in the tangential rows")) along = before(0);
  if (slip("no restitution")) up = before(1) + gained(1);
  if (slip("phi/dt added to p(0)")) up += 0.0005 / P.dt;
  Eigen::Vector4d p(up, -along, along, 0);
  if (slip("sign of p(2)")) p(2) = -p(2);
  if (slip("p all negated")) p = -p;
  return p;
}

Lcp form(const Jacobian& J, const Vector3& v, const Parameters& given) {
  const Parameters P = with_parameter_slips(given, "lmuegd");
  return {responses(J, P), rates(J, v, P)};
}

// --- part 3: impulses along the ground and upwards ---

// A is the answer to impulses, `rate` what they have to cancel.
Pair impulses(const Eigen::Matrix2d& A, const Pair& rate, const Pair& start, double mu) {
  if (rate(1) >= 0) return Pair::Zero();
  Pair P = -A.inverse() * rate;
  if (slip("no friction")) return {0, -rate(1) / A(1, 1)};
  if (slip("f_n = -p(0)/V(0,0) without coupling, friction clamped")) {
    P = -rate.cwiseQuotient(A.diagonal());
    return {std::clamp(P(0), -mu * P(1), mu * P(1)), P(1)};
  }
  if (slip("sticking clamped by Coulomb afterwards")) {
    const double most = mu * std::max(0.0, P(1));
    return {std::clamp(P(0), -most, most), std::max(0.0, P(1))};
  }
  const bool slides = std::fabs(P(0)) > mu * P(1);
  if (slip("always sticking") || (!slides && !slip("always sliding"))) return P;
  const double way = rate(0) - A(0, 1) / A(1, 1) * rate(1);
  const double side = slip("mu f_n against the start's sliding") ? -sign(start(0)) : -sign(way);
  const double up = -rate(1) / (A(1, 1) + side * mu * A(1, 0));
  return {side * mu * up, up};
}

bool is_close(const Vector3& q, const Vector3& v, double phi, const Jacobian& J,
              const Parameters& P) {
  if (slip("contact by phi < 0")) return phi < 0;
  if (slip("contact by phi < 0.05")) return phi < 0.05;
  if (slip("contact by phi < 2 delta")) return phi < 2 * P.delta;
  if (slip("contact by y < l/2")) return q(1) < P.l / 2;
  if (slip("contact by |phi| < delta")) return std::fabs(phi) < P.delta;
  if (slip("contact by phi of q + dt v, J of this")) {
    return bounce::get_contacts(q + P.dt * v, P).phi < P.delta;
  }
  const bool leaves = J.col(1).dot(v) >= 0;
  if (slip("no contact when it already leaves") && leaves) return false;
  return phi < P.delta;
}

Vector3 pushed(const Jacobian& J, const Vector3& v, const Vector3& free, const Parameters& P) {
  const Vector3 w = P.M().diagonal().cwiseInverse();
  const Pair start = J.transpose() * v;
  Pair rate = J.transpose() * free;
  rate(1) += P.epsilon * start(1);
  if (slip("v of the LCP with gravity already")) {
    rate = J.transpose() * (2 * free - v);
    rate(1) += P.epsilon * J.col(1).dot(free);
  }
  Pair impulse = impulses(J.transpose() * w.asDiagonal() * J, rate, start, P.mu);
  if (slip("sign of friction")) impulse(0) = -impulse(0);
  if (slip("forces with the wrong sign")) impulse = -impulse;
  if (slip("forces taken as impulses, no dt")) impulse /= P.dt;
  Vector3 push = J * impulse;
  if (slip("forces as (f_x, f_y) at J's rows: no torque")) push(2) = 0;
  if (slip("torque with the wrong sign")) push(2) = -push(2);
  if (slip("M^-1 forgotten for the forces")) return free + push;
  const bool bare = slip("gravity left out in contact");
  return (bare ? v : free) + w.cwiseProduct(push) +
         (slip("gravity twice in contact") ? Vector3(P.dt * P.g) : Vector3::Zero());
}

State one_step(const Vector3& q, const Vector3& v, const Parameters& P) {
  Vector3 from = q;
  if (slip("q moved before the forces")) from += P.dt * v;
  Contact contact = bounce::get_contacts(from, P);
  if (slip("J of the next configuration, phi of this")) {
    contact.J = bounce::get_contacts(q + P.dt * v, P).J;
  }
  const bool touches = is_close(from, v, contact.phi, contact.J, P);
  const Vector3 free = v + P.dt * P.g;
  Vector3 next = touches ? pushed(contact.J, v, free, P) : free;
  if (touches && slip("lift in v'")) next(1) += P.delta;
  const bool old =
      slip("old velocity moves q") || (touches && slip("old velocity moves q while touching"));
  Vector3 moved = from + P.dt * (old ? v : next);
  double lift = P.delta;
  if (slip("lift left out")) lift = 0;
  if (slip("lift of max(0, -phi)")) lift = std::max(0.0, -contact.phi);
  if (slip("lift of -delta")) lift = -P.delta;
  if (slip("lift times dt")) lift *= P.dt;
  if (touches || slip("lift in flight too")) moved(slip("lift along x") ? 0 : 1) += lift;
  return {moved, next};
}

State stepped(const Vector3& q, const Vector3& v, const Parameters& given) {
  Parameters P = with_parameter_slips(given, "lmuegdD");
  State s = slip("step(v, q)") ? State{v, q} : State{q, v};
  const int substeps = slip("two substeps of dt/2") ? 2 : 1;
  P.dt /= substeps;
  for (int i = 0; i < substeps; ++i) s = one_step(s.q, s.v, P);
  if (slip("theta wrapped to -pi ... pi")) s.q(2) = std::remainder(s.q(2), 2 * pi);
  if (slip("{v, q} returned")) return {s.v, s.q};
  return s;
}

// --- part 4: a function of the last column makes the next one ---

State next_column(int column, const State& now, const State& first, const Parameters& P) {
  const bool touches = bounce::get_contacts(now.q, P).phi < P.delta;
  State next = bounce::step(now.q, now.v, P);
  if (slip("step called twice for each column")) next = bounce::step(next.q, next.v, P);
  if (slip("always steps from column 0")) next = bounce::step(first.q, first.v, P);
  if (slip("v_0 passed to every step")) next = bounce::step(now.q, first.v, P);
  if (slip("step(v, q)")) next = bounce::step(now.v, now.q, P);
  if (slip("own flight loop, no contact")) {
    next.v = now.v + P.dt * P.g;
    next.q = now.q + P.dt * next.v;
  }
  if (slip("column 1 repeats column 0") && column == 1) next = now;
  if (slip("stops at the first contact") && touches) next = now;
  if (slip("stops at a small velocity") && now.v.norm() < 0.5) next = now;
  if (slip("float storage")) {
    next.q = next.q.cast<float>().cast<double>();
    next.v = next.v.cast<float>().cast<double>();
  }
  if (slip("theta wrapped")) next.q(2) = std::remainder(next.q(2), 2 * pi);
  return next;
}

Trajectory filmed(const Vector3& q_0, const Vector3& v_0, const Parameters& given) {
  const Parameters P = with_parameter_slips(given, "TlmuegdD");
  State first{q_0, v_0};
  const bool all = slip("the assignment's q_0 and v_0 written down");
  if (all || slip("the assignment's q_0 written down")) first.q = Vector3(0, 1.5, pi / 6);
  if (all) first.v = Vector3(0, -0.2, 0);
  if (slip("v_0 ignored, 0")) first.v.setZero();
  if (slip("q_0 and v_0 exchanged")) std::swap(first.q, first.v);
  const int T = std::max(1, P.T);
  Trajectory film{Eigen::Matrix3Xd::Zero(3, T), Eigen::Matrix3Xd::Zero(3, T)};
  film.q.col(0) = first.q;
  if (!slip("v_0 never stored")) film.v.col(0) = first.v;
  const int to = slip("last column left at zero") ? T - 1 : T;
  State now = first;
  for (int t = 1; t < to; ++t) {
    const State next = next_column(t, now, first, P);
    film.q.col(t) = next.q;
    film.v.col(t) = slip("v of the column before stored") ? now.v : next.v;
    now = next;
  }
  if (slip("q and v exchanged")) std::swap(film.q, film.v);
  return film;
}

}  // namespace

const Style& contact_frame() {
  static const Style style{touching, form, stepped, filmed};
  return style;
}

}  // namespace slips
