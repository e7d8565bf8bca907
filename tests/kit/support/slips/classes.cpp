// All parts in one more style: classes that hold the state of the square.
#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/solve_lcp.hpp>
#include <cmath>
#include <vector>

#include "whole_styles.hpp"

namespace slips {
namespace {

// The corner of a quadrant goes round by quarter turns, so that each comes from the one before.
class Square {
 public:
  Square(const Vector3& q, const Parameters& params) : centre_(q(0), q(1)) {
    const double angle = slip("theta turns the wrong way") ? -q(2)
                         : slip("theta unused")            ? 0
                         : slip("q(1) as the angle")       ? q(1)
                                                           : q(2);
    const double side = slip("l = 0.4 written down")                ? 0.4
                        : slip("l = 0.2 written down")              ? 0.2
                        : slip("half side where the side is meant") ? params.l / 2
                                                                    : params.l;
    const Eigen::Vector2d ahead(std::cos(angle), std::sin(angle));
    const Eigen::Vector2d aside(-ahead.y(), ahead.x());
    arm_ = side / 2 * (ahead + (slip("sign of a half diagonal") ? -1 : 1) * aside);
    if (slip("half diagonal is l")) arm_ *= std::sqrt(2.0);
  }

  Contact lowest() const {
    Eigen::Vector2d found = arm_, next = arm_;
    const int others = slip("one corner too few") ? 2 : 3;
    for (int k = 0; k < others; ++k) {
      next = Eigen::Vector2d(-next.y(), next.x());
      if (slip("every corner from the first")) next = Eigen::Vector2d(-arm_.y(), arm_.x());
      if (slip("highest corner") ? next.y() > found.y() : next.y() < found.y()) found = next;
    }
    if (slip("always the first corner")) found = arm_;
    return {jacobian(found), height(found)};
  }

 private:
  double height(const Eigen::Vector2d& r) const {
    if (slip("phi = r_y, centre forgotten")) return r.y();
    if (slip("phi = q(1)")) return centre_.y();
    if (slip("phi with the other sign")) return -centre_.y() - r.y();
    if (slip("phi clamped at 0")) return std::max(0.0, centre_.y() + r.y());
    return centre_.y() + r.y();
  }
  Jacobian jacobian(Eigen::Vector2d r) const {
    if (slip("r from the world's origin")) r += centre_;
    if (slip("r from the corner to the centre")) r = -r;
    Jacobian J = Jacobian::Identity();
    J(2, 0) = slip("sign of r_y in J_t") ? r.y() : -r.y();
    J(2, 1) = slip("sign of r_x in J_n") ? -r.x() : r.x();
    if (slip("moment arm left out of J_n")) J(2, 1) = 0;
    if (slip("columns exchanged, [J_n J_t]")) J.col(0).swap(J.col(1));
    if (slip("J_n = (0, -1, -r_x)")) J.col(1) = -J.col(1);
    return J;
  }
  Eigen::Vector2d centre_, arm_;
};

Contact square(const Vector3& q, const Parameters& params) { return Square(q, params).lowest(); }

// Two coordinates of the contact, n and t, and the mass that resists along each.
class ContactSpace {
 public:
  ContactSpace(const Jacobian& J, const Parameters& params) : J_(J), params_(params) {
    if (slip("dt = 0.01 written down")) params_.dt = 0.01;
    if (slip("mu = 0.3 written down")) params_.mu = 0.3;
    if (slip("all constants at the top")) params_ = Parameters();
    inertia_ = params_.m * params_.l * params_.l / (slip("inertia l^2/12") ? 12 : 6);
    if (slip("inertia of a point, m l^2")) inertia_ *= 6;
  }

  double mobility(int a, int b) const {
    const double linear = J_.col(a).head<2>().dot(J_.col(b).head<2>()) / params_.m;
    const double angular = J_(2, a) * J_(2, b) / inertia_;
    const double sum = slip("sum stops before theta") ? linear : linear + angular;
    return sum * (slip("dt left out of V") ? 1
                  : slip("dt^2 in V")      ? params_.dt * params_.dt
                                           : params_.dt);
  }

  double velocity(int a, const Vector3& v, double restitution) const {
    const double gravity = slip("g = (0, -9.81, 0) written down") ? -9.81 * J_(1, a)
                           : slip("g points up")                  ? -J_.col(a).dot(params_.g)
                                                                  : J_.col(a).dot(params_.g);
    return restitution * J_.col(a).dot(v) + params_.dt * gravity;
  }

  Lcp lcp(const Vector3& v) const {
    const double nn = mobility(1, 1), nt = mobility(0, 1), tt = mobility(0, 0), mu = params_.mu;
    const double couple = slip("J_hat = [J_n J_t -J_t]") ? -nt : nt;
    Lcp found{Eigen::Matrix4d::Zero(), Eigen::Vector4d::Zero()};
    found.V << nn, -couple, couple, 0, -couple, tt, -tt, 1, couple, -tt, tt, 1, mu, -1, -1, 0;
    if (slip("last row mu 1 1 0")) found.V.row(3) << mu, 1, 1, 0;
    if (slip("last row 1 -mu -mu 0")) found.V.row(3) << 1, -mu, -mu, 0;
    if (slip("last column zero")) found.V.col(3).setZero();
    if (slip("last column 0 -1 -1 0")) found.V.col(3) *= -1;
    const double e = params_.epsilon;
    const double restitution = slip("epsilon in place of 1 + epsilon") ? e
                               : slip("no restitution")                ? 1
                               : slip("epsilon is an int")             ? 1 + static_cast<int>(e)
                                                                       : 1 + e;
    const double along = velocity(0, v, slip("1 + epsilon in the tangential rows") ? 1 + e : 1);
    found.p << velocity(1, v, restitution), -along, along, 0;
    if (slip("p all negated")) found.p *= -1;
    if (slip("sign of p(2)")) found.p(2) *= -1;
    if (slip("p(1) and p(2) exchanged")) std::swap(found.p(1), found.p(2));
    if (slip("mu in p(3)")) found.p(3) = mu;
    return found;
  }

 private:
  Jacobian J_;
  Parameters params_;
  double inertia_ = 0;
};

Lcp contact_space(const Jacobian& J, const Vector3& v, const Parameters& params) {
  return ContactSpace(J, params).lcp(v);
}

class Body {
 public:
  Body(const Vector3& q, const Vector3& v, const Parameters& params)
      : q_(q), v_(v), old_(v), params_(params) {
    if (slip("delta = 0.001 written down")) params_.delta = 0.001;
    if (slip("epsilon = 0.5 written down")) params_.epsilon = 0.5;
    if (slip("dt = 0.001 written down")) params_.dt = 0.001;
    if (slip("g = 0")) params_.g.setZero();
  }

  State after_a_step() {
    const Contact contact = bounce::get_contacts(q_, params_);
    const double limit = slip("contact by phi < 0")      ? 0
                         : slip("contact by phi < 0.05") ? 0.05
                         : slip("contact by phi < dt")   ? params_.dt
                                                         : params_.delta;
    const bool touches = contact.phi < limit && !slip("contact never");
    const Lcp lcp = bounce::form_lcp(contact.J, v_, params_);
    if (!(touches && slip("gravity left out in contact"))) v_ += params_.dt * params_.g;
    if (touches) push(contact, lcp);
    move(touches);
    if (slip("{v, q} returned")) return {v_, q_};
    return {q_, v_};
  }

 private:
  void push(const Contact& contact, const Lcp& lcp) {
    Vector3 f = bounce::solve_lcp(lcp.V, lcp.p);
    if (slip("no friction")) f.tail<2>().setZero();
    if (slip("sign of friction")) std::swap(f(1), f(2));
    if (slip("forces taken as (f_t1, f_t2, f_n)")) f = Vector3(f(2), f(0), f(1));
    if (slip("forces halved")) f /= 2;
    Vector3 force = contact.J.col(1) * f(0) + contact.J.col(0) * (f(2) - f(1));
    if (slip("torque with the wrong sign")) force(2) *= -1;
    if (slip("omega not changed")) force(2) = 0;
    const double dt = slip("forces taken as impulses, no dt") ? 1 : params_.dt;
    v_ += dt * params_.M().inverse() * force;
  }
  void move(bool touches) {
    const bool old =
        slip("old velocity moves q") || (touches && slip("old velocity moves q while touching"));
    q_ += params_.dt * (old ? old_ : v_);
    const double lift = slip("lift left out")    ? 0
                        : slip("lift times dt")  ? params_.delta * params_.dt
                        : slip("lift of -delta") ? -params_.delta
                                                 : params_.delta;
    if (touches || slip("lift in flight too")) q_(slip("lift along x") ? 0 : 1) += lift;
  }
  Vector3 q_, v_, old_;
  Parameters params_;
};

State body(const Vector3& q, const Vector3& v, const Parameters& params) {
  return Body(q, v, params).after_a_step();
}

class Film {
 public:
  explicit Film(const Parameters& params) : params_(params) {}

  Trajectory shot(const Vector3& q_0, const Vector3& v_0) {
    State now{q_0, slip("v_0 ignored, 0") ? Vector3(0, 0, 0) : v_0};
    if (slip("first column is already a step")) now = next(now);
    const int T = params_.T + (slip("T = 151") ? 1 : slip("T - 1 columns") ? -1 : 0);
    for (int t = 0; t < T; ++t) {
      frames_.push_back(now);
      if (slip("state not updated")) frames_.back() = t == 0 ? now : next(now);
      if (!slip("state not updated")) now = next(now);
      if (slip("step called twice for each column")) now = next(now);
    }
    Trajectory found{Eigen::Matrix3Xd(3, T), Eigen::Matrix3Xd(3, T)};
    for (int t = 0; t < T; ++t) {
      found.q.col(t) = frames_[static_cast<std::size_t>(t)].q;
      found.v.col(t) = frames_[static_cast<std::size_t>(t)].v;
    }
    if (slip("v_0 never stored") && T > 0) found.v.col(0).setZero();
    if (slip("q and v exchanged")) std::swap(found.q, found.v);
    return found;
  }

 private:
  State next(const State& state) const {
    Parameters params = slip("the default parameters passed on") ? Parameters() : params_;
    if (slip("l = 0.4 written down")) params.l = 0.4;
    State found = Body(state.q, state.v, params).after_a_step();
    if (slip("own flight loop, no contact")) {
      found.v = state.v + params.dt * params.g;
      found.q = state.q + params.dt * found.v;
    }
    if (slip("theta wrapped")) found.q(2) = std::remainder(found.q(2), 2 * std::acos(-1.0));
    return found;
  }
  Parameters params_;
  std::vector<State> frames_;
};

Trajectory film(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  return Film(params).shot(q_0, v_0);
}

}  // namespace

const Style& classes() {
  static const Style style{square, contact_space, body, film};
  return style;
}

}  // namespace slips
