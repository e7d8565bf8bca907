#include "event_driven.hpp"

#include <algorithm>
#include <numbers>

#include "../methods/two_corners.hpp"
#include "first_contact.hpp"
#include "series.hpp"

namespace bounce::exact {
namespace {

using methods::CornerImpulse;
using methods::ImpactLaw;
using methods::Row;
using methods::SideImpulse;

// Up to two corners, in the order of eq. (3).
struct Corners {
  int count = 0;
  Row<int, 2> index{};
  void add(int k) { index[count++] = k; }
};

template <class Real>
class Engine {
 public:
  Engine(const Parameters& params, const Motion<Real>& start, const std::vector<Real>& times,
         const EventOptions& options, EventReport& report)
      : body_(params), s_(start), times_(times), options_(options), report_(report) {
    if (!options.model.friction) body_.mu = 0;
    cut_ = Real(options.cut);
    order_ = std::clamp(int(4 - std::log(options.tolerance) / 2), 6, kMaxOrder);
    end_ = times.empty() ? Real(0) : times.back();
    events_left_ = std::max(1000L, long(double(options.events_a_second) * double(end_)));
  }

  std::vector<Motion<Real>> run() {
    samples_.reserve(times_.size());
    collide();
    while (samples_.size() < times_.size()) {
      if (events_left_-- <= 0) {
        report_.capped = true;
        break;
      }
      if (closed_.count == 0) {
        fly_on();
      } else if (closed_.count == 1) {
        follow_corner();
      } else {
        follow_side();
      }
    }
    return std::move(samples_);
  }

 private:
  // Moves on to time t, taking samples on the way; at(t) is the motion between.
  template <class At>
  void advance(Real t, double& mode, const At& at) {
    while (samples_.size() < times_.size() && times_[samples_.size()] <= t)
      samples_.push_back(at(times_[samples_.size()] - t_));
    s_ = at(t - t_);
    mode += double(t - t_);
    t_ = t;
  }

  void fly_on() {
    const Motion<Real> start = s_;
    const Real last = end_ - t_;
    const Real contact = options_.model.corners == 0 ? std::numeric_limits<Real>::infinity()
                                                     : first_contact(start, body_, last);
    const bool lands = contact < last;
    advance(lands ? t_ + contact : end_, report_.flight,
            [&](Real t) { return fly(start, body_, t); });
    if (lands) collide();
  }

  // The corners that touch the ground.
  Corners touching(const Row<Arm<Real>, 4>& r) const {
    Corners found;
    const Real limit = Real(options_.touching);
    for (int k = 0; k < 4 && found.count < 2; ++k)
      if (s_.y + r[k].y <= limit) found.add(k);
    return found;
  }

  // As many of these as the model allows: of two, the corner that approaches faster.
  Corners within_model(Corners hit, const Row<Arm<Real>, 4>& r) const {
    if (hit.count == 2 && options_.model.corners < 2) {
      const Real first = methods::normal_velocity(s_, r[hit.index[0]]);
      const Real second = methods::normal_velocity(s_, r[hit.index[1]]);
      if (second < first) hit.index[0] = hit.index[1];
    }
    hit.count = std::min(hit.count, options_.model.corners);
    return hit;
  }

  // The end of a flight.
  void collide() {
    const auto r = methods::arms(body_, s_.theta);
    collide(touching(r), r);
  }

  // The end of one corner's motion: its neighbour lands. Both touch, whatever the heights say: they
  // are as far from 0 as the series are from the truth, which may be more than what touches.
  void land(int k, int neighbour) {
    Corners both;
    both.add(std::min(k, neighbour));
    both.add(std::max(k, neighbour));
    collide(both, methods::arms(body_, s_.theta));
  }

  // The impact of all corners that touch. Corners that are pressed and don't leave stay closed.
  void collide(const Corners& touching, const Row<Arm<Real>, 4>& r) {
    const Corners hit = within_model(touching, r);
    closed_ = {};
    if (hit.count == 0) return;
    ++report_.impacts;
    if (hit.count == 1) {
      collide_corner(hit.index[0], r[hit.index[0]]);
    } else {
      collide_side(hit, r);
    }
  }

  void collide_corner(int k, const Arm<Real>& r) {
    methods::Collision<Real> collision = collision_at(r);
    const bool rests = collision.v_n > -cut_ || -collision.v_n * body_.epsilon < cut_;
    if (collision.v_n < 0) {
      if (rests) collision.epsilon = 0;
      const CornerImpulse<Real> p = methods::impact(collision, options_.law);
      methods::push(s_, r, p.n, p.t, body_.gyration);
    }
    if (rests && collision.v_n < cut_) close(k, r);
  }

  methods::Collision<Real> collision_at(const Arm<Real>& r) const {
    const auto k = methods::one_corner<Real>(r, body_.gyration, 0, 0, body_.mu);
    return {k.a,
            k.b,
            k.c,
            methods::normal_velocity(s_, r),
            methods::sliding_velocity(s_, r),
            body_.mu,
            body_.epsilon};
  }

  // Two corners. Restitution applies to corners that approach; the v_n of the other just must not
  // become negative. Newton: one LCP. Poisson (Glocker & Pfeiffer 1995, "Multiple impacts with
  // friction in rigid multibody systems", Nonlinear Dynamics 7): compression, then expansion with
  // at least epsilon p_i at each corner. Stronge's law is the same as Poisson's here: while both
  // corners stay pressed and the side goes on sliding or sticking, v_n is linear in P.
  void collide_side(const Corners& hit, const Row<Arm<Real>, 4>& r) {
    const Arm<Real>&r_1 = r[hit.index[0]], &r_2 = r[hit.index[1]];
    Row<Real, 2> before{methods::normal_velocity(s_, r_1), methods::normal_velocity(s_, r_2)};
    const Real approach = std::min(before[0], before[1]);
    const Real epsilon = -approach * body_.epsilon < cut_ ? Real(0) : body_.epsilon;
    Row<Real, 2> pressed{};
    if (approach < 0) {
      if (options_.law == ImpactLaw::newton) {
        pressed = press(r_1, r_2,
                        {before[0] + epsilon * std::min(before[0], Real(0)),
                         before[1] + epsilon * std::min(before[1], Real(0))});
      } else {
        pressed = press(r_1, r_2, before);
        if (epsilon > 0) expand(r_1, r_2, pressed, epsilon);
      }
    }
    const Real after_1 = methods::normal_velocity(s_, r_1);
    const Real after_2 = methods::normal_velocity(s_, r_2);
    if (std::max(after_1, after_2) < cut_ && settles(s_.v_x - (r_1.y + r_2.y) / 2 * s_.omega)) {
      closed_ = hit;
      return;
    }
    // A corner stays closed if it was pressed without enough speed to bounce.
    const auto stays = [&](int i, Real after) {
      return after < cut_ && (approach >= 0 || (pressed[i] > 0 && after < cut_ / 100));
    };
    if (stays(0, after_1)) {
      close(hit.index[0], r_1);
    } else if (stays(1, after_2)) {
      close(hit.index[1], r_2);
    }
  }

  // Applies the impulses of the side's LCP for these u, and returns the normal ones.
  Row<Real, 2> press(const Arm<Real>& r_1, const Arm<Real>& r_2, Row<Real, 2> u, Real P_0 = 0) {
    const Real u_t = s_.v_x - (r_1.y + r_2.y) / 2 * s_.omega;
    const SideImpulse<Real> p = methods::solve_two_corners(
        methods::two_corners(r_1, r_2, body_.gyration, u, u_t, body_.mu, P_0));
    push_side(r_1, r_2, p);
    return p.n;
  }

  void push_side(const Arm<Real>& r_1, const Arm<Real>& r_2, const SideImpulse<Real>& p) {
    methods::push(s_, r_1, p.n[0], p.t / 2, body_.gyration);
    methods::push(s_, r_2, p.n[1], p.t / 2, body_.gyration);
  }

  void expand(const Arm<Real>& r_1, const Arm<Real>& r_2, const Row<Real, 2>& p, Real epsilon) {
    methods::push(s_, r_1, epsilon * p[0], Real(0), body_.gyration);
    methods::push(s_, r_2, epsilon * p[1], Real(0), body_.gyration);
    press(r_1, r_2, {methods::normal_velocity(s_, r_1), methods::normal_velocity(s_, r_2)},
          epsilon * (p[0] + p[1]));
  }

  // Lays the square flat if the side, its corners at rest along n, stays on the ground: if both
  // are pressed while it slides with v_t, or once it has stopped, where cut is enough to stop it.
  bool settles(Real v_t) {
    if (std::abs(v_t) <= slow()) v_t = 0;
    const SideImpulse<Real> f = side_force(v_t);
    if (!(f.n[0] > 0 && f.n[1] > 0)) {
      if (std::abs(v_t) >= cut_) return false;
      const SideImpulse<Real> stopped = side_force(Real(0));
      const bool sticks = std::abs(stopped.t) < body_.mu * (stopped.n[0] + stopped.n[1]);
      if (!sticks || !(stopped.n[0] > 0 && stopped.n[1] > 0)) return false;
      v_t = 0;
    }
    lay_flat(v_t);
    return true;
  }

  // Removes what cut has left of v_y and omega, and of theta and y.
  void lay_flat(Real v_t) {
    const Real quarter = std::numbers::pi_v<Real> / 2;
    s_.theta = std::round(s_.theta / quarter) * quarter;
    s_.y = body_.half;
    s_.v_x = v_t;
    s_.v_y = s_.omega = 0;
  }

  // The side's forces per unit of mass, with the square lying flat.
  SideImpulse<Real> side_force(Real v_t) const {
    const methods::TwoCorners<Real> k{{-body_.half, body_.half},
                                      -body_.half,
                                      body_.gyration,
                                      {body_.g_y, body_.g_y},
                                      body_.g_x,
                                      body_.mu,
                                      0};
    if (std::abs(v_t) <= slow()) return methods::solve_two_corners(k);
    return methods::solve_side(k, v_t > 0 ? 1 : -1, false);
  }

  // Slower sliding than this is only the rounding error of an impact, and counts as none.
  Real slow() const { return 1000 * std::numeric_limits<Real>::epsilon(); }

  // Closes one corner: v_n is 0 from now on, and the mode is still to be found.
  void close(int k, const Arm<Real>& r) {
    closed_ = {};
    closed_.add(k);
    s_.v_y = -r.x * s_.omega;
    s_.y = -r.y;
    sliding_ = Sliding::unknown;
  }

  enum class Sliding { unknown, left = -1, no = 0, right = 1 };

  // One corner on the ground.
  void follow_corner() {
    const int k = closed_.index[0];
    const Arm<Real> r = methods::arms(body_, s_.theta)[k];
    if (sliding_ == Sliding::unknown && !find_mode(r)) return;
    const CornerMotion<Real> motion(body_, s_, r, direction_, order_);
    ++report_.series;
    Real reach = std::min(motion.reach(Real(options_.tolerance)), end_ - t_);
    const auto [guard, time] = motion.first_guard(reach);
    const bool ends = guard != Guard::none && time <= reach;
    const Real t = ends ? t_ + time : std::min(t_ + reach, end_);
    advance(t, report_.corner, [&](Real at) { return motion.at(at); });
    if (ends) leave_mode(guard, k);
  }

  // Finds the mode by the LCP in accelerations; false if the corner doesn't stay.
  bool find_mode(const Arm<Real>& r) {
    const Real v_t = methods::sliding_velocity(s_, r);
    auto forces =
        methods::one_corner<Real>(r, body_.gyration, body_.g_y - r.y * s_.omega * s_.omega,
                                  body_.g_x - r.x * s_.omega * s_.omega, body_.mu);
    if (std::abs(v_t) > slow()) {
      direction_ = v_t > 0 ? 1 : -1;
      if (forces.u_n < 0 && forces.a - Real(direction_) * forces.mu * forces.b <= 0) {
        jam(r);
        return false;
      }
    } else {
      const CornerImpulse<Real> f = methods::solve_one_corner(forces);
      direction_ = f.happens == methods::Case::slides_right  ? 1
                   : f.happens == methods::Case::slides_left ? -1
                                                             : 0;
      s_.v_x = r.y * s_.omega;
    }
    if (forces.u_n >= 0) {
      closed_ = {};
      return false;
    }
    sliding_ = Sliding(direction_);
    return true;
  }

  // The impact without approach that stops the sliding corner.
  void jam(const Arm<Real>& r) {
    ++report_.jams;
    const auto k = methods::one_corner<Real>(r, body_.gyration, 0, 0, body_.mu);
    const Real v_t = methods::sliding_velocity(s_, r), D = k.a * k.c - k.b * k.b;
    methods::push(s_, r, k.b * v_t / D, -k.a * v_t / D, body_.gyration);
    s_.v_x = r.y * s_.omega;
  }

  void leave_mode(Guard guard, int k) {
    const auto r = methods::arms(body_, s_.theta);
    switch (guard) {
      case Guard::lands_left:  // each arm is the one before, turned by a right angle
        land(k, (k + 3) % 4);
        break;
      case Guard::lands_right:
        land(k, (k + 1) % 4);
        break;
      case Guard::lifts:
        closed_ = {};
        break;
      case Guard::stops_sliding:
        s_.v_x = r[k].y * s_.omega;
        sliding_ = Sliding::unknown;
        break;
      case Guard::slips_right:
        direction_ = 1;
        sliding_ = Sliding::right;
        break;
      case Guard::slips_left:
        direction_ = -1;
        sliding_ = Sliding::left;
        break;
      case Guard::none:
        break;
    }
  }

  // A side on the ground. Forces are constant until sliding stops.
  void follow_side() {
    const SideImpulse<Real> f = side_force(s_.v_x);
    if (!(f.n[0] > 0 && f.n[1] > 0)) {  // it tips over the corner that is pressed, or lifts off
      const auto r = methods::arms(body_, s_.theta);
      const bool right = f.n[1] > f.n[0];
      const int k = closed_.index[(r[closed_.index[1]].x > 0) == right ? 1 : 0];
      closed_ = {};
      if (f.n[0] > 0 || f.n[1] > 0) close(k, r[k]);
      return;
    }
    const Motion<Real> start = s_;
    const Real a = f.t + body_.g_x;
    const Real stop = start.v_x * a < 0 ? -start.v_x / a : std::numeric_limits<Real>::infinity();
    const bool stops = t_ + stop < end_;
    const bool moves = std::abs(start.v_x) > slow() || std::abs(a) > slow();
    advance(stops ? t_ + stop : end_, report_.flat, [&](Real t) {
      Motion<Real> s = start;
      if (!moves) return s;
      s.x += t * (s.v_x + a * t / 2);
      s.v_x += a * t;
      return s;
    });
    if (stops) s_.v_x = 0;
  }

  Body<Real> body_;
  Motion<Real> s_;
  const std::vector<Real>& times_;
  EventOptions options_;
  EventReport& report_;
  std::vector<Motion<Real>> samples_;
  Real t_ = 0, end_ = 0, cut_ = 0;
  int order_ = 0;
  long events_left_ = 0;
  Corners closed_;
  Sliding sliding_ = Sliding::unknown;
  int direction_ = 0;
};

}  // namespace

template <class Real>
std::vector<Motion<Real>> simulate_events(const Parameters& params, const Motion<Real>& start,
                                          const std::vector<Real>& times,
                                          const EventOptions& options, EventReport* report) {
  EventReport unread;
  return Engine<Real>(params, start, times, options, report ? *report : unread).run();
}

template std::vector<Motion<double>> simulate_events(const Parameters&, const Motion<double>&,
                                                     const std::vector<double>&,
                                                     const EventOptions&, EventReport*);
template std::vector<Motion<long double>> simulate_events(const Parameters&,
                                                          const Motion<long double>&,
                                                          const std::vector<long double>&,
                                                          const EventOptions&, EventReport*);

}  // namespace bounce::exact
