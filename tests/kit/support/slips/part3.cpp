#include "part3.hpp"
#include <Eigen/LU>
#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/solve_lcp.hpp>
#include <cmath>
#include <numbers>

namespace slips {
namespace {
const std::string names = "lmuegdD";

// The forces (f_n, f_t1, f_t2), by the given solver or by the three cases of friction.
Vector3 by_cases(const Eigen::Matrix4d& V, const Eigen::Vector4d& p, const Parameters& P) {
  const double a = V(0, 0), b = V(0, 2), c = V(2, 2);
  const double mu = V(3, 0);
  double fn = -p(0) / a;
  if (p(0) >= 0 && !slip("force may pull")) return Vector3::Zero();
  double det = a * c - b * b, ft = 0;
  fn = (-p(0) * c + p(2) * b) / det;
  ft = (-p(2) * a + p(0) * b) / det;
  const bool slides = std::fabs(ft) > mu * fn;
  if (slip("always sticking")) return {fn, std::max(0.0, -ft), std::max(0.0, ft)};
  if (slides || slip("always sliding")) {
    // Sliding to the right pushes left; which one is consistent decides.
    for (const double side : {-1.0, 1.0}) {
      const double f = -p(0) / (a + side * mu * b);
      const double after = p(2) + b * f + c * side * mu * f;
      if (f >= 0 && side * after <= 0) {
        fn = f;
        ft = side * mu * f;
        return {fn, std::max(0.0, -ft), std::max(0.0, ft)};
      }
    }
    if (slip("always sliding")) {
      const double side = p(2) > 0 ? -1 : 1;
      fn = -p(0) / (a + side * mu * b);
      return {fn, side < 0 ? mu * fn : 0, side > 0 ? mu * fn : 0};
    }
  }
  (void)P;
  return {fn, std::max(0.0, -ft), std::max(0.0, ft)};
}

Vector3 forces(const Lcp& lcp, const Parameters& P, bool cases) {
  Eigen::Matrix4d V = lcp.V;
  Eigen::Vector4d p = lcp.p;
  const double a = V(0, 0), b = V(0, 2), c = V(2, 2), mu = V(3, 0);
  if (slip("solve_lcp(V, -p)")) p = -p;
  if (slip("solve_lcp(-V, p)")) V = -V;
  if (slip("solve_lcp(V^T, p)")) V.transposeInPlace();
  Vector3 f = cases ? by_cases(V, p, P) : solve_lcp(V, p);
  if (slip("f_n = -p(0)/V(0,0) without coupling, friction clamped")) {
    const double fn = std::max(0.0, -p(0) / a), ft = std::clamp(-p(2) / c, -mu * fn, mu * fn);
    f = {fn, std::max(0.0, -ft), std::max(0.0, ft)};
  }
  if (slip("f_n = -p(0)/V(0,0) without coupling, friction after it")) {
    const double fn = std::max(0.0, -p(0) / a),
                 ft = std::clamp(-(p(2) + b * fn) / c, -mu * fn, mu * fn);
    f = {fn, std::max(0.0, -ft), std::max(0.0, ft)};
  }
  if (slip("sticking clamped by Coulomb afterwards")) {
    const double det = a * c - b * b, fn = std::max(0.0, (-p(0) * c + p(2) * b) / det);
    const double ft = std::clamp((-p(2) * a + p(0) * b) / det, -mu * fn, mu * fn);
    f = p(0) >= 0 ? Vector3::Zero() : Vector3(fn, std::max(0.0, -ft), std::max(0.0, ft));
  }
  if (slip("V solved as plain equations")) f = (V.fullPivLu().solve(-p)).head<3>();
  if (slip("block of V solved as plain equations, clamped at 0")) {
    f = (V.topLeftCorner<3, 3>().completeOrthogonalDecomposition().solve(-p.head<3>()));
    f = f.cwiseMax(0);
  }
  if (slip("mu f_n against the start's sliding")) {
    const double fn = f(0), side = p(2) > 0 ? -1 : 1;
    f = {fn, side < 0 ? mu * fn : 0, side > 0 ? mu * fn : 0};
  }
  if (slip("no friction")) f(1) = f(2) = 0;
  if (slip("no normal force")) f(0) = 0;
  if (slip("sign of friction")) std::swap(f(1), f(2));
  if (slip("friction to one side alone")) f(1) = 0;
  if (slip("forces taken as (f_t1, f_t2, f_n)")) f = Vector3(f(2), f(0), f(1));
  if (slip("forces taken as (f_t1, f_n, f_t2)")) f = Vector3(f(1), f(0), f(2));
  if (slip("friction added up, f_t1 + f_t2")) f = Vector3(f(0), 0, f(1) + f(2));
  if (slip("forces twice")) f *= 2;
  if (slip("forces halved")) f *= 0.5;
  if (slip("mu times friction")) f.tail<2>() *= mu;
  if (slip("forces kept from the last contact")) {
    auto& kept = program().kept["f"];
    const Vector3 now = f;
    if (kept.size()) f = kept;
    kept = now;
  }
  return f;
}

Vector3 gravity(const Vector3& M, const Parameters& P) {
  Vector3 f = M.cwiseProduct(P.g);
  if (slip("f_e = g, M^-1 f_e")) f = P.g;
  if (slip("f_e = -M g")) f = -f;
  if (slip("gravity left out")) f.setZero();
  if (slip("gravity twice")) f *= 2;
  Vector3 a = f.cwiseQuotient(M);
  if (slip("m g as an acceleration")) a = M.cwiseProduct(P.g);
  if (slip("sign of gravity")) a = -a;
  if (slip("gravity in y alone")) a = Vector3(0, a(1), 0);
  return a;
}

State general(const Vector3& q_given, const Vector3& v_given, const Parameters& given, bool cases,
              bool impulses) {
  const Parameters P = with_parameter_slips(given, names);
  Vector3 q = q_given, v = v_given;
  if (slip("step(v, q)")) std::swap(q, v);
  if (slip("theta wrapped to 2 pi")) q(2) = std::fmod(q(2), 2 * std::numbers::pi);
  if (slip("theta wrapped to -pi ... pi")) q(2) = std::remainder(q(2), 2 * std::numbers::pi);
  if (slip("theta wrapped to 0 ... 2 pi"))
    q(2) -= 2 * std::numbers::pi * std::floor(q(2) / (2 * std::numbers::pi));
  Vector3 M(P.m, P.m, P.m * P.l * P.l / 6);
  if (slip("inertia l^2/12")) M(2) /= 2;
  if (slip("inertia of a point")) M(2) *= 6;
  if (slip("inertia is m")) M(2) = P.m;
  const int substeps = slip("two substeps of dt/2") ? 2 : slip("ten substeps of dt/10") ? 10 : 1;
  const double dt = P.dt / substeps;
  State s{q, v};
  for (int i = 0; i < substeps; ++i) {
    q = s.q;
    v = s.v;
    Parameters Q = P;
    Q.dt = dt;
    Vector3 q_of_contact = q;
    const Vector3 a = gravity(M, Q);
    if (slip("contact and J of q + dt v")) q_of_contact += dt * v;
    if (slip("contact and J of the free next configuration")) q_of_contact += dt * (v + dt * a);
    if (slip("q moved before the forces")) {
      q += dt * v;
      q_of_contact = q;
    }
    if (slip("q moved half a step before the forces")) {
      q += dt / 2 * v;
      q_of_contact = q;
    }
    Contact contact = get_contacts(q_of_contact, Q);
    double phi = contact.phi;
    if (slip("contact by phi of the next configuration, J of this")) {
      phi = get_contacts(q + dt * (v + dt * a), Q).phi;
    }
    if (slip("contact by phi of q + dt v, J of this")) {
      phi = get_contacts(q + dt * v, Q).phi;
    }
    if (slip("J of the next configuration, phi of this")) contact.J = get_contacts(q + dt * v, Q).J;
    bool touches = phi < P.delta;
    if (slip("contact by phi < 0")) touches = phi < 0;
    if (slip("contact by phi < 2 delta")) touches = phi < 2 * P.delta;
    if (slip("contact by phi < 3 delta")) touches = phi < 3 * P.delta;
    if (slip("contact by phi < 0.002")) touches = phi < 0.002;
    if (slip("contact by phi < 0.02")) touches = phi < 0.02;
    if (slip("contact by phi < 0.05")) touches = phi < 0.05;
    if (slip("contact by phi < 0.1")) touches = phi < 0.1;
    if (slip("contact by phi < dt/2")) touches = phi < P.dt / 2;
    if (slip("contact by phi < l/4")) touches = phi < P.l / 4;
    if (slip("contact by phi < l/2")) touches = phi < P.l / 2;
    if (slip("contact by phi < dt")) touches = phi < P.dt;
    if (slip("contact by phi > delta")) touches = phi > P.delta;
    if (slip("contact by |phi| < delta")) touches = std::fabs(phi) < P.delta;
    if (slip("contact by phi > 0 && phi < delta")) touches = phi > 0 && phi < P.delta;
    if (slip("contact by y < delta")) touches = q(1) < P.delta;
    if (slip("contact by y < l/2")) touches = q(1) < P.l / 2;
    if (slip("contact always")) touches = true;
    if (slip("contact never")) touches = false;
    if (slip("contact by phi < -delta")) touches = phi < -P.delta;
    if (slip("contact by phi <= 1e-6")) touches = phi <= 1e-6;
    const double vn = contact.J.col(1).dot(v);
    if (slip("no contact when it already leaves")) touches = touches && vn < 0;
    if (slip("no contact when v_y > 0")) touches = touches && v(1) < 0;
    if (slip("contact kept from the last call")) {
      auto& kept = program().kept["touches"];
      const bool now = touches;
      if (kept.size()) touches = kept(0) > 0;
      kept = Eigen::MatrixXd::Constant(1, 1, now);
    }
    if (!touches) {
      Vector3 v_new = v + dt * a;
      if (slip("free flight without gravity")) v_new = v;
      if (slip("dt^2 on gravity in free flight")) v_new = v + dt * dt * a;
      Vector3 q_new = q + dt * v_new;
      if (slip("old velocity moves q") || slip("old velocity moves q in flight"))
        q_new = q + dt * v;
      if (slip("mean velocity moves q") || slip("mean velocity moves q in flight"))
        q_new = q + dt * 0.5 * (v + v_new);
      if (slip("q + dt v + dt^2/2 a in flight")) q_new = q + dt * v + dt * dt / 2 * a;
      if (slip("q + dt v' + dt^2/2 a in flight")) q_new = q + dt * v_new + dt * dt / 2 * a;
      if (slip("lift in flight too")) q_new(1) += P.delta;
      if (slip("q without dt")) q_new = q + v_new;
      if (slip("q is not moved in flight")) q_new = q;
      if (slip("theta not moved in flight")) q_new(2) = q(2);
      s = {q_new, v_new};
      continue;
    }
    Vector3 v_lcp = v;
    if (slip("v of the LCP with gravity already")) v_lcp = v + dt * a;
    Lcp lcp = form_lcp(contact.J, v_lcp, Q);
    Vector3 f = forces(lcp, Q, cases);
    Vector3 t = contact.J.col(0), n = contact.J.col(1);
    if (slip("J_t and J_n exchanged")) std::swap(t, n);
    Vector3 force = n * f(0) + t * (f(2) - f(1));
    if (slip("forces as (f_x, f_y) at J's rows: no torque")) force(2) = 0;
    if (slip("torque with the wrong sign")) force(2) = -force(2);
    if (slip("no moment of friction")) force(2) = n(2) * f(0);
    if (slip("no moment of the normal force")) force(2) = t(2) * (f(2) - f(1));
    if (slip("moment of friction with the wrong sign")) force(2) -= 2 * t(2) * (f(2) - f(1));
    if (slip("moment of the normal force with the wrong sign")) force(2) -= 2 * n(2) * f(0);
    if (slip("forces with the wrong sign")) force = -force;
    Vector3 w = M.cwiseInverse();
    if (slip("M^-1 forgotten for the forces")) w.setOnes();
    if (slip("M in place of M^-1 for the forces")) w = M;
    if (slip("1/m for the torque too")) w(2) = 1 / M(0);
    Vector3 a_contact = a;
    if (slip("gravity left out in contact")) a_contact.setZero();
    if (slip("gravity twice in contact")) a_contact *= 2;
    const double dt_forces = slip("forces taken as impulses, no dt") ? 1
                             : slip("dt^2 on the forces")            ? dt * dt
                                                                     : dt;
    Vector3 v_new = impulses ? Vector3(v + dt * a_contact + w.cwiseProduct(force * dt_forces))
                             : Vector3(v + dt * a_contact + dt_forces * w.cwiseProduct(force));
    if (slip("gravity with dt^2 in contact")) v_new += (dt * dt - dt) * a_contact;
    if (slip("v not added, v' = dt M^-1 (...)")) v_new -= v;
    if (slip("lift in v'")) v_new(1) += P.delta;
    if (slip("v_y reversed by hand, -epsilon v_y")) v_new = Vector3(v(0), -P.epsilon * v(1), v(2));
    if (slip("restitution once more")) {
      v_new(1) *= P.epsilon;
    }
    if (slip("omega not changed")) v_new(2) = v(2);
    if (slip("v_x not changed")) v_new(0) = v(0);
    Vector3 q_new = q + dt * v_new;
    if (slip("old velocity moves q") || slip("old velocity moves q while touching"))
      q_new = q + dt * v;
    if (slip("mean velocity moves q") || slip("mean velocity moves q while touching"))
      q_new = q + dt * 0.5 * (v + v_new);
    if (slip("free velocity moves q while touching")) q_new = q + dt * (v + dt * a);
    if (slip("q without dt")) q_new = q + v_new;
    if (slip("q is not moved while touching")) q_new = q;
    double lift = P.delta;
    if (slip("lift left out")) lift = 0;
    if (slip("lift of max(0, -phi)")) lift = std::max(0.0, -contact.phi);
    if (slip("lift of -phi")) lift = -contact.phi;
    if (slip("lift of delta - phi")) lift = P.delta - contact.phi;
    if (slip("lift of -delta")) lift = -P.delta;
    if (slip("lift times dt")) lift *= dt;
    if (slip("lift of 2 delta")) lift *= 2;
    if (slip("lift of 0.001")) lift = 0.001;
    if (slip("lift of l/100")) lift = P.l / 100;
    if (slip("lift only with a force") && f(0) <= 0) lift = 0;
    if (slip("lift only below the ground") && contact.phi >= 0) lift = 0;
    if (slip("lift only when v_n' < 0") && contact.J.col(1).dot(v_new) >= 0) lift = 0;
    q_new(slip("lift along x") ? 0 : slip("lift of theta") ? 2 : 1) += lift;
    if (slip("lift of all three")) {
      q_new(0) += lift;
      q_new(2) += lift;
    }
    if (slip("y set to 0")) q_new(1) = std::max(q_new(1), 0.0);
    if (slip("lift in place of the move, q' = q + lift")) q_new = q + Vector3(0, lift, 0);
    s = {q_new, v_new};
  }
  if (slip("{v, q} returned")) return {s.v, s.q};
  if (slip("q returned unchanged")) return {q_given, s.v};
  if (slip("v returned unchanged")) return {s.q, v_given};
  if (slip("theta' in degrees")) s.q(2) *= 180 / std::numbers::pi;
  if (slip("state stored as float"))
    return {s.q.cast<float>().cast<double>(), s.v.cast<float>().cast<double>()};
  if (slip("slow v is set to 0") && s.v.norm() < 0.5) s.v.setZero();
  return s;
}
State lcp(const Vector3& q, const Vector3& v, const Parameters& p) {
  return general(q, v, p, false, false);
}
State no_lcp(const Vector3& q, const Vector3& v, const Parameters& p) {
  return general(q, v, p, true, false);
}
State impulses(const Vector3& q, const Vector3& v, const Parameters& p) {
  return general(q, v, p, false, true);
}

State helper_step(const Vector3& q, const Vector3& v, const Parameters& P) {
  // The right step, for part 4.
  const Contact contact = get_contacts(q, P);
  Vector3 force = Vector3::Zero();
  double lift = 0;
  if (contact.phi < P.delta) {
    const Lcp lcp = form_lcp(contact.J, v, P);
    const Vector3 f = solve_lcp(lcp.V, lcp.p);
    force = contact.J.col(1) * f(0) + contact.J.col(0) * (f(2) - f(1));
    lift = P.delta;
  }
  const Vector3 M(P.m, P.m, P.m * P.l * P.l / 6);
  const Vector3 v_new = v + P.dt * (P.g + force.cwiseQuotient(M));
  return {q + P.dt * v_new + Vector3(0, lift, 0), v_new};
}

Trajectory part4(const Vector3& q_given, const Vector3& v_given, const Parameters& given) {
  const Parameters P = with_parameter_slips(given, "TlmuegdD");
  Vector3 q_0 = q_given, v_0 = v_given;
  if (slip("the assignment's q_0 and v_0 written down")) {
    q_0 = Vector3(0, 1.5, std::numbers::pi / 6);
    v_0 = Vector3(0, -0.2, 0);
  }
  if (slip("the assignment's q_0 written down")) q_0 = Vector3(0, 1.5, std::numbers::pi / 6);
  if (slip("v_0 ignored, 0")) v_0.setZero();
  if (slip("q_0 and v_0 exchanged")) std::swap(q_0, v_0);
  if (slip("q_0(2) in degrees")) q_0(2) *= std::numbers::pi / 180;
  const int T = std::max(0, P.T);
  Eigen::Matrix3Xd Q = Eigen::Matrix3Xd::Zero(3, T), W = Eigen::Matrix3Xd::Zero(3, T);
  if (!T) return {Q, W};
  State s{q_0, v_0};
  if (slip("first column is already a step")) s = helper_step(s.q, s.v, P);
  Q.col(0) = s.q;
  if (!slip("v_0 never stored")) W.col(0) = s.v;
  if (slip("column 0 left at zero")) {
    Q.col(0).setZero();
    W.col(0).setZero();
  }
  if (slip("q_0 never stored")) Q.col(0).setZero();
  int from = 1, to = T;
  if (slip("last column left at zero")) to = T - 1;
  if (slip("loop from column 2")) from = 2;
  if (slip("stops after 100 columns")) to = std::min(T, 100);
  bool stopped = false;
  for (int t = from; t < to; ++t) {
    State next = helper_step(s.q, s.v, P);
    if (slip("step called twice for each column")) next = helper_step(next.q, next.v, P);
    if (slip("step called for q, and again for v from the new q"))
      next.v = helper_step(next.q, s.v, P).v;
    if (slip("own flight loop, no contact")) {
      next.v = s.v + P.dt * P.g;
      next.q = s.q + P.dt * next.v;
    }
    if (slip("own flight with the old velocity, no contact")) {
      next.v = s.v + P.dt * P.g;
      next.q = s.q + P.dt * s.v;
    }
    if (slip("own flight loop while y > l") && s.q(1) > P.l) {
      next.v = s.v + P.dt * P.g;
      next.q = s.q + P.dt * s.v;
    }
    if (slip("always steps from column 0")) next = helper_step(q_0, v_0, P);
    if (slip("steps from two columns before") && t >= 2)
      next = helper_step(Q.col(t - 2), W.col(t - 2), P);
    if (slip("v_0 passed to every step")) next = helper_step(s.q, v_0, P);
    if (slip("q_0 passed to every step")) next = helper_step(q_0, s.v, P);
    if (slip("column 1 repeats column 0") && t == 1) next = s;
    if (slip("the default parameters passed on")) {
      Parameters D;
      next = helper_step(s.q, s.v, D);
    }
    if (slip("stops at the first contact") && (stopped || get_contacts(s.q, P).phi < P.delta)) {
      stopped = true;
      next = s;
    }
    if (slip("zero after the first contact") && (stopped || get_contacts(s.q, P).phi < P.delta)) {
      stopped = true;
      break;
    }
    if (slip("stops at a small velocity") && s.v.norm() < 0.5) next = s;
    if (slip("float storage")) {
      next.q = next.q.cast<float>().cast<double>();
      next.v = next.v.cast<float>().cast<double>();
    }
    if (slip("theta wrapped")) next.q(2) = std::remainder(next.q(2), 2 * std::numbers::pi);
    if (slip("y clamped at 0")) next.q(1) = std::max(0.0, next.q(1));
    if (slip("step(v, q)")) next = helper_step(s.v, s.q, P);
    if (slip("q and v of the result exchanged")) std::swap(next.q, next.v);
    Q.col(t) = next.q;
    W.col(t) = next.v;
    if (slip("v of the column before stored")) W.col(t) = s.v;
    if (slip("q of the column before stored")) Q.col(t) = s.q;
    if (slip("v never stored")) W.col(t).setZero();
    if (slip("state not updated")) continue;
    s = next;
    if (slip("v not updated")) s.v = v_0;
    if (slip("q not updated")) s.q = q_0;
  }
  if (slip("transposed")) {
    const Eigen::MatrixXd a = Q, b = W;
    Q = Eigen::Map<const Eigen::Matrix3Xd>(Eigen::MatrixXd(a.transpose()).data(), 3, T);
    W = Eigen::Map<const Eigen::Matrix3Xd>(Eigen::MatrixXd(b.transpose()).data(), 3, T);
  }
  if (slip("q and v exchanged")) std::swap(Q, W);
  if (slip("rows x and y exchanged")) {
    Q.row(0).swap(Q.row(1));
    W.row(0).swap(W.row(1));
  }
  if (slip("time runs backwards")) {
    Q = Q.rowwise().reverse().eval();
    W = W.rowwise().reverse().eval();
  }
  return {Q, W};
}
}  // namespace

const std::map<std::string, Step>& part3_styles() {
  static const std::map<std::string, Step> styles{
      {"loop", lcp}, {"closed form without LCP", no_lcp}, {"impulses", impulses}};
  return styles;
}
const std::map<std::string, Simulate>& part4_styles() {
  static const std::map<std::string, Simulate> styles{{"loop", part4}};
  return styles;
}
}  // namespace slips
