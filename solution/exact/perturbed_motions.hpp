// Three slightly perturbed motions that follow a reference motion, to measure how fast errors grow.
//
// In flight each moves by itself. When the reference has an impact, corner k of a perturbed motion
// is at a height h and strikes t = -h / v_n later: that motion is advanced by t, struck, and taken
// back by t, so that all are at the same time again. That is the saltation matrix of Aizerman &
// Gantmacher (1958, "On the stability of periodic motion", J. Appl. Math. Mech. 22) by a finite
// difference. It looks for no contact and takes few operations, where a second simulation takes as
// long as the first.
//
// This is valid as long as all of them have the same impacts, each of a single corner, and none so
// slow that its time is uncertain. After that the perturbed motions are lost, and no distance is
// measured any more. There are three of them, because one or two may happen to be perturbed in a
// direction that hardly grows.
#pragma once

#include "../methods/impact_laws.hpp"
#include "first_contact.hpp"
#include "noise.hpp"

namespace bounce::exact {

// Whether only corner k of these is near the ground.
template <class Real>
bool is_alone(int k, const methods::Row<Arm<Real>, 4>& r, Real y) {
  for (int other = 0; other < 4; ++other)
    if (other != k && y + r[other].y < Real(1e-9)) return false;
  return true;
}

template <class Real>
class PerturbedMotions {
 public:
  PerturbedMotions() = default;

  // The noise perturbs them at every impact; without noise they are lost.
  PerturbedMotions(const Motion<Real>& start, const Noise& noise)
      : all_{start, start, start}, noise_(noise), lost_(noise.size() == 0) {}

  bool lost() const { return lost_; }
  void lose() { lost_ = true; }

  // The largest distance from the reference so far, m.
  Real apart() const { return apart_; }

  // Advances them by `time` in free flight; `reference` is the reference motion at its end.
  // Distances are convex in the time of a flight, so they are largest at its ends.
  void fly_to(const Motion<Real>& reference, const Body<Real>& body, Real time) {
    if (lost_) return;
    flown_ += time;
    Real square = 0;
    for (Motion<Real>& s : all_) {
      s = fly(s, body, time);
      const Real x = s.x - reference.x, y = s.y - reference.y;
      const Real turned = body.rho * (s.theta - reference.theta);
      square = std::max(square, x * x + y * y + turned * turned);
    }
    if (struck_) apart_ = std::max(apart_, std::sqrt(square));
  }

  void turn(Real angle) {
    for (Motion<Real>& s : all_) s.theta += angle;
  }

  // The impact of the corner whose arm is r in the reference, which is turned by theta.
  void collide(const Arm<Real>& r, Real theta, const Body<Real>& body, methods::ContactMode mode,
               methods::ImpactLaw law) {
    for (Motion<Real>& s : all_) collide(s, r, theta, body, mode, law);
    struck_ = true;
    flown_ = 0;
  }

 private:
  void collide(Motion<Real>& s, Arm<Real> r, Real theta, const Body<Real>& body,
               methods::ContactMode mode, methods::ImpactLaw law) {
    disturb(s, body, flown_, noise_);
    r = turned(r, s.theta - theta);
    const Real v_n = methods::normal_velocity(s, r);
    if (!(v_n < -Real(1e-4))) return lose();
    const Real late = (4 * Real(noise_.size()) * body.rho - s.y - r.y) / -v_n;
    s = fly(s, body, late);
    r = turned(r, s.omega * late);
    const methods::CornerImpulse<Real> p = methods::impact(methods::collision_of(s, r, body), law);
    if (p.mode != mode) return lose();
    methods::apply_impulse(s, r, p.n, p.t, body.gyration_squared);
    s = fly(s, body, -late);
  }

  // By an angle whose square is beyond rounding.
  static Arm<Real> turned(const Arm<Real>& r, Real angle) {
    return {r.x - angle * r.y, r.y + angle * r.x};
  }

  methods::Row<Motion<Real>, 3> all_{};
  Noise noise_{0, 1};
  bool lost_ = true, struck_ = false;
  Real flown_ = 0;  // since the last impact
  Real apart_ = 0;
};

}  // namespace bounce::exact
