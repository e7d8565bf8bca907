// The ground: impacts of one corner or of a side on it, and which of them stay there.
//
// Zeno: bounces that get ever smaller end where a bounce would leave with less than `cut`: the
// impact is then without restitution, and contact lasts. What is left out lasts 2 cut / (g (1 -
// epsilon)) and is cut^2 / (2 g) high: 2e-6 sqrt(l / g) / (1 - epsilon) and 5e-13 l with the usual
// cut. A bounce much lower than that drowns in the rounding of y. The impulses left out act along
// the same line; the corner or side that stays is given the rest of them, with its friction, so
// that v and omega change by the square of cut only.
#pragma once

#include <algorithm>
#include <limits>
#include <numbers>

#include "../methods/impact_laws.hpp"
#include "../methods/two_corners.hpp"

namespace bounce::study {

// Up to two corners, in the order of eq. (3).
struct Corners {
  int count = 0;
  Row<int, 2> index{};
  void add(int k) { index[count++] = k; }
};

// Slower sliding than this is only the rounding error of an impact, and counts as none.
template <class Real>
Real slow(const Motion<Real>& s, const Body<Real>& body) {
  return 1000 * std::numeric_limits<Real>::epsilon() *
         (1 + std::abs(s.v_x) + body.rho * std::abs(s.omega));
}

// The forces of a side on the ground per unit of mass, of a square that lies flat.
template <class Real>
SideImpulse<Real> side_force(const Motion<Real>& s, const Body<Real>& body, Real v_t) {
  const TwoCorners<Real> k{{-body.half, body.half}, -body.half, body.gyration_squared,
                           {body.g_y, body.g_y},    body.g_x,   body.mu};
  if (std::abs(v_t) <= slow(s, body)) return solve_two_corners(k);
  return solve_side(k, v_t > 0 ? 1 : -1, false);
}

template <class Real>
class Ground {
 public:
  Ground(const Body<Real>& body, Real cut) : body_(body), cut_(cut) {}

  // The impact of one or two corners, whose arms are in r. Returns those that stay on the ground:
  // one, whose v_n is 0 from now on; both, and the square lies flat; or none.
  Corners collide(Motion<Real>& s, const Corners& hit, const Row<Arm<Real>, 4>& r) {
    return hit.count == 1 ? collide_corner(s, hit.index[0], r) : collide_side(s, hit, r);
  }

  // Gives a corner what is left of its impulses, those that take its v_n away, with their friction.
  void stop_leaving(Motion<Real>& s, const Arm<Real>& r) const {
    const Collision<Real> k = collision_of(s, r, body_);
    const int sigma = std::abs(k.v_t) > slow(s, body_) ? (k.v_t > 0 ? 1 : -1) : 0;
    Real friction = -Real(sigma) * k.mu;  // p_t / p_n
    const auto p_n = [&] { return -k.v_n / (k.a + k.b * friction); };
    const bool goes_on = sigma != 0 && k.a + k.b * friction > 0 &&
                         Real(sigma) * (k.v_t + (k.b + k.c * friction) * p_n()) > 0;
    if (!goes_on) {  // it sticks, as far as friction can hold it
      const Real N = k.b * k.v_t - k.c * k.v_n, T = k.b * k.v_n - k.a * k.v_t;
      const bool slow_enough = std::abs(k.v_t) < 10 * cut_ && N != 0;
      friction = slow_enough ? std::clamp(T / N, -k.mu, k.mu) : Real(0);
      if (!(k.a + k.b * friction > 0)) friction = 0;
    }
    const Real p = p_n();
    apply_impulse(s, r, p, friction * p, body_.gyration_squared);
  }

 private:
  Corners collide_corner(Motion<Real>& s, int k, const Row<Arm<Real>, 4>& arms) {
    const Arm<Real>& r = arms[k];
    Collision<Real> collision = collision_of(s, r, body_);
    const bool rests = is_cut(collision.v_n, cut_at(s, r));
    if (collision.v_n < 0) {
      if (rests) collision.epsilon = 0;
      const auto p = newton_impact(collision);
      apply_impulse(s, r, p.n, p.t, body_.gyration_squared);
      if (p.mode == ContactMode::sticks) s.v_x = r.y * s.omega;
    }
    if (!(rests && normal_velocity(s, r) < cut_at(s, r))) return {};
    stop_leaving(s, r);
    return {1, {k}};
  }

  // Two corners, in one LCP. Restitution applies to corners that approach; the v_n of the other
  // just must not become negative.
  Corners collide_side(Motion<Real>& s, const Corners& hit, const Row<Arm<Real>, 4>& r) {
    const Arm<Real>&r_1 = r[hit.index[0]], &r_2 = r[hit.index[1]];
    const Row<Real, 2> before{normal_velocity(s, r_1), normal_velocity(s, r_2)};
    const Real approach = std::min(before[0], before[1]);
    const Arm<Real> middle{(r_1.x + r_2.x) / 2, (r_1.y + r_2.y) / 2};
    const Real epsilon = is_cut(approach, cut_at(s, middle)) ? Real(0) : body_.epsilon;
    Row<Real, 2> pressed{};
    if (approach < 0) {
      pressed = press(s, r_1, r_2,
                      {before[0] + epsilon * std::min(before[0], Real(0)),
                       before[1] + epsilon * std::min(before[1], Real(0))});
    }
    if (std::abs(s.omega) < slow(s, body_)) s.omega = 0;  // it leaves flat, but for rounding
    const Real cut = cut_at(s, middle), v_t = tangential_velocity(s, middle);
    const Row<Real, 2> after{normal_velocity(s, r_1), normal_velocity(s, r_2)};
    if (std::max(after[0], after[1]) < cut && settles(s, v_t, cut)) return hit;
    // A corner stays closed if it was pressed without enough speed to bounce.
    const auto stays = [&](int i) {
      return after[i] < cut && (approach >= 0 || (pressed[i] > 0 && after[i] < cut / 100));
    };
    if (!stays(0) && !stays(1)) return {};
    const bool is_second = stays(1) && (!stays(0) || tips_on(r_2, r_1, s, v_t));
    const int k = hit.index[is_second ? 1 : 0];
    stop_leaving(s, r[k]);
    return {1, {k}};
  }

  // Whether the side presses on the first of these corners more than on the other: on that a square
  // tips which doesn't stay flat. Where friction leaves no forces, that is the one in front.
  bool tips_on(const Arm<Real>& corner, const Arm<Real>& other, const Motion<Real>& s,
               Real v_t) const {
    const SideImpulse<Real> f = side_force(s, body_, v_t);  // of the left corner and the right one
    const Real more = f.n[1] - f.n[0];
    return ((more == 0 ? v_t : more) > 0) == (corner.x > other.x);
  }

  // Applies the impulses of the side's LCP for these u, and returns the normal ones.
  Row<Real, 2> press(Motion<Real>& s, const Arm<Real>& r_1, const Arm<Real>& r_2,
                     const Row<Real, 2>& u) const {
    const Real u_t = s.v_x - (r_1.y + r_2.y) / 2 * s.omega;
    const SideImpulse<Real> p =
        solve_two_corners(two_corners(r_1, r_2, body_.gyration_squared, u, u_t, body_.mu));
    push_side(s, r_1, r_2, p, body_.gyration_squared);
    return p.n;
  }

  // Lays the square flat if the side, its corners at rest along n, stays on the ground: if both
  // are pressed while it slides with v_t, or once it has stopped, where cut is enough to stop it.
  bool settles(Motion<Real>& s, Real v_t, Real cut) {
    const auto pressed = [](const SideImpulse<Real>& f) { return f.n[0] > 0 && f.n[1] > 0; };
    const SideImpulse<Real> f = side_force(s, body_, v_t);
    if (pressed(f)) {
      const bool moves = std::abs(v_t) > slow(s, body_);
      const Real way = moves ? v_t : f.t + body_.g_x;
      lay_flat(s, moves || std::abs(f.t) >= most_friction(f) ? (way > 0) - (way < 0) : 0);
      return true;
    }
    if (std::abs(v_t) >= cut) return false;
    const SideImpulse<Real> stopped = side_force(s, body_, Real(0));
    if (!pressed(stopped) || std::abs(stopped.t) >= most_friction(stopped)) return false;
    lay_flat(s, 0);
    return true;
  }

  Real most_friction(const SideImpulse<Real>& f) const { return body_.mu * (f.n[0] + f.n[1]); }

  // Lays the side on the ground, and gives it what is left of its impulses: those that take v_y and
  // omega away, with their friction. sigma is the direction in which it slides, 0 if it sticks.
  void lay_flat(Motion<Real>& s, int sigma) {
    const Real quarter = std::numbers::pi_v<Real> / 2;
    s.theta = std::round(s.theta / quarter) * quarter;
    s.y = body_.half;
    const Real rest = Real(sigma) * body_.mu * s.v_y, v_x = s.v_x + rest;
    s.v_x = sigma == 0 || (rest != 0 && Real(sigma) * v_x < 0) ? Real(0) : v_x;
    s.v_y = s.omega = 0;
    cuts_ = 0;
  }

  // A corner that leaves more slowly than this comes back at once. Where it hardly comes back,
  // since gravity or rotation lifts it, no bounce is left out. On a slope a square that is at rest
  // but for the cut may draw as much from it in each hop as its impacts take; so cuts that go on
  // are made larger.
  Real cut_at(const Motion<Real>& s, const Arm<Real>& r) const {
    const Real falls = std::clamp(r.y * s.omega * s.omega - body_.g_y, Real(0), Real(1));
    return (cuts_ > 50 ? 100 : 1) * cut_ * falls;
  }

  // Whether restitution ends here: a corner that approaches like this would leave too slowly.
  bool is_cut(Real v_n, Real cut) {
    if (v_n < -1000 * cut_) cuts_ = 0;
    const bool ends = v_n > -cut || -v_n * body_.epsilon < cut;
    cuts_ += ends;
    return ends;
  }

  const Body<Real>& body_;
  Real cut_;
  int cuts_ = 0;  // impacts whose restitution was cut since the last that was fast
};

}  // namespace bounce::study
