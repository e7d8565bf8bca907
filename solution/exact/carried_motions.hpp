// Three motions that are carried along with a reference motion, to measure its error.
//
// One is the same motion in long double: its distance from the reference is what rounding did, but
// for a share of 2^-11. The other two are perturbed at every impact, by much more than rounding
// does, and say how fast errors grow. There are two, because one alone may happen to be perturbed
// in a direction that hardly grows.
//
// In flight each moves by itself. When the reference has an impact, corner k of a carried motion is
// at a height h and strikes t = -h / v_n later: that motion is advanced by t, struck, and taken
// back by t, so that all are at the same time again. That is the saltation matrix of Aizerman &
// Gantmacher (1958, "On the stability of periodic motion", J. Appl. Math. Mech. 22) by a finite
// difference. It looks for no contact and takes few operations, where a second simulation takes as
// long as the first.
//
// This is valid as long as all of them have the same impacts, each of a single corner, and none so
// slow that its time is uncertain. After that they are lost, and no distance is measured any more.
#pragma once

#include "../methods/impact_laws.hpp"
#include "first_contact.hpp"
#include "noise.hpp"

namespace bounce::exact {

// How far the carried motions are from the reference up to some time, m.
struct CarriedDistances {
  double perturbed, finer;
};

// The size of (dx, dy, rho dtheta), or `least` if that is larger. The differences are taken in the
// precision of the first, and little time is lost where they are small.
template <class Precise, class Real>
double apart(const Motion<Precise>& one, const Motion<Real>& other, double rho, double least = 0) {
  const auto x = double(one.x - other.x), y = double(one.y - other.y);
  const double turned = rho * double(one.theta - other.theta);
  const double square = x * x + y * y + turned * turned;
  return square <= least * least ? least : std::sqrt(square);
}

// Whether only corner k of these is near the ground.
template <class Real>
bool is_alone(int k, const methods::Row<Arm<Real>, 4>& r, Real y) {
  for (int other = 0; other < 4; ++other)
    if (other != k && y + r[other].y < Real(1e-9)) return false;
  return true;
}

template <class Real>
class CarriedMotions {
 public:
  // The noise perturbs two of them; without noise they are lost.
  CarriedMotions(const Motion<Real>& start, const Parameters& params, const Noise& noise)
      : body_(params),
        finer_body_(params),
        rho_(double(body_.rho)),
        perturbed_{start, start},
        finer_{start.x, start.y, start.theta, start.v_x, start.v_y, start.omega},
        noise_(noise),
        lost_(noise.size() == 0) {}

  bool lost() const { return lost_; }
  void lose() { lost_ = true; }

  // Advances them by `time` in free flight; `reference` is the reference motion at its end.
  // Distances are convex in the time of a flight, so they are largest at its ends.
  void fly_to(const Motion<Real>& reference, Real time) {
    if (lost_) return;
    flown_ += time;
    finer_ = fly<long double>(finer_, finer_body_, time);
    for (Motion<Real>& s : perturbed_) {
      s = fly(s, body_, time);
      if (struck_) distances_.perturbed = apart(s, reference, rho_, distances_.perturbed);
    }
  }

  // The distances at the end of the flight, or this much earlier (time < 0), when the reference is
  // there, its theta with `turns` more turns than that of the carried motions.
  CarriedDistances at(long double time, const Motion<Real>& reference, Real turns) {
    Motion<long double> s = fly(finer_, finer_body_, time);
    s.theta += turns * kTurn<long double>;
    distances_.finer = apart(s, reference, rho_, distances_.finer);
    return distances_;
  }

  // Takes whole turns out of theta, as that changed by `change` to `theta` in the reference. A
  // product of turns and 2 pi would round a large theta.
  void turn(Real change, Real theta) {
    for (Motion<Real>& s : perturbed_) s.theta += change;
    const long double rest = std::atan2(std::sin(finer_.theta), std::cos(finer_.theta));
    finer_.theta = rest + std::round((theta - rest) / kTurn<long double>) * kTurn<long double>;
  }

  // The impact of corner k in the reference, whose arms are r and which is turned by theta.
  void collide(int k, const methods::Row<Arm<Real>, 4>& r, Real theta, methods::ContactMode mode,
               methods::ImpactLaw law) {
    for (Motion<Real>& s : perturbed_) {
      disturb(s, body_, flown_, noise_);
      strike(s, turned(r[k], s.theta - theta), 4 * Real(noise_.size()) * body_.rho, body_, mode,
             law);
    }
    strike<long double>(finer_, methods::arms(finer_body_, finer_.theta)[k], 0, finer_body_, mode,
                        law);
    struck_ = true;
    flown_ = 0;
  }

 private:
  template <class Precision>
  static constexpr Precision kTurn = 2 * std::numbers::pi_v<Precision>;

  // Strikes the corner whose arm is r when it is at this height.
  template <class Precision>
  void strike(Motion<Precision>& s, Arm<Precision> r, Precision height, const Body<Precision>& body,
              methods::ContactMode mode, methods::ImpactLaw law) {
    const Precision v_n = methods::normal_velocity(s, r);
    if (!(v_n < -Precision(1e-4))) return lose();
    const Precision late = (s.y + r.y - height) / -v_n;
    s = fly(s, body, late);
    r = turned(r, s.omega * late);
    const auto p = methods::impact(methods::collision_of(s, r, body), law);
    if (p.mode != mode) return lose();
    methods::apply_impulse(s, r, p.n, p.t, body.gyration_squared);
    s = fly(s, body, -late);
  }

  // By an angle whose square is beyond rounding.
  template <class Precision>
  static Arm<Precision> turned(const Arm<Precision>& r, Precision angle) {
    return {r.x - angle * r.y, r.y + angle * r.x};
  }

  Body<Real> body_;
  Body<long double> finer_body_;
  double rho_;
  methods::Row<Motion<Real>, 2> perturbed_;
  Motion<long double> finer_;
  Noise noise_;
  bool lost_, struck_ = false;
  Real flown_ = 0;  // since the last impact
  CarriedDistances distances_{};
};

}  // namespace bounce::exact
