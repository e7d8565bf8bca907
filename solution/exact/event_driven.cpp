#include "event_driven.hpp"

#include <algorithm>
#include <limits>
#include <numbers>

#include "../methods/two_corners.hpp"
#include "carried_motions.hpp"
#include "first_contact.hpp"
#include "series.hpp"
#include "units.hpp"

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
      : body_(params),
        s_(start),
        times_(times),
        options_(options),
        report_(report),
        carried_(start, params, Noise(options.perturbation, options.seed)) {
    if (!options.model.friction) body_.mu = 0;
    cut_ = Real(options.cut);
    set_turns_apart();
    order_ = std::clamp(int(4 - std::log(options.tolerance) / 2), 6, kMaxOrder);
  }

  std::vector<Motion<Real>> run() {
    samples_.reserve(times_.size());
    if (!carried_.lost()) report_.distances.reserve(times_.size());
    collide();
    while (samples_.size() < times_.size()) {
      report_.stalled = stalls();
      report_.gave_up = options_.most_events > 0 && events_++ >= options_.most_events;
      if (report_.stalled || report_.gave_up) break;
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
  // Whether a thousand events have gone by in less time than a few bounces as low as the cut take.
  bool stalls() {
    if (since_mark_ > 100 * cut_) {
      since_mark_ = 0;
      events_since_mark_ = 0;
    }
    return ++events_since_mark_ > 1000;
  }

  // The time until the last sample.
  Real last() const { return clock_.until(times_.back()); }

  // Moves on by `time`, taking samples on the way; at(t) is the motion t later than now.
  template <class At>
  void advance(Real time, double& mode, const At& at) {
    while (samples_.size() < times_.size()) {
      const Real sample = times_[samples_.size()], later = clock_.until(sample);
      if (!(later <= time)) break;
      samples_.push_back(at(later));
      Motion<Real>& s = samples_.back();
      s.theta += turns_ * 2 * std::numbers::pi_v<Real>;
      if (carried_.lost()) continue;
      const long double since_end = clock_.template until<long double>(sample) - time;
      report_.distances.push_back(carried_.at(since_end, s, turns_));
    }
    s_ = at(time);
    set_turns_apart();
    mode += double(time);
    clock_.advance(time);
    since_mark_ += time;
  }

  // Keeps theta within half a turn.
  void set_turns_apart() {
    if (std::abs(s_.theta) <= std::numbers::pi_v<Real>) return;
    const Real rest = std::atan2(std::sin(s_.theta), std::cos(s_.theta));
    turns_ += std::round((s_.theta - rest) / (2 * std::numbers::pi_v<Real>));
    carried_.turn(rest - s_.theta, rest);
    s_.theta = rest;
  }

  void fly_on() {
    const Motion<Real> start = s_;
    const Real last = this->last();
    const Real above =
        options_.model.corners == 0 ? last : std::min(time_above(start, body_), last);
    const NearFlight<Real> flight =
        above > 0 ? NearFlight<Real>{above, false} : first_contact(start, body_, last);
    carried_.fly_to(fly(start, body_, flight.time), flight.time);
    advance(flight.time, report_.flight, [&](Real t) { return fly(start, body_, t); });
    if (flight.contact) {
      disturb(flight.time);
      put_on_ground();
      collide();
    } else if (above > 0 && above < last) {
      s_.y = body_.rho;
    }
  }

  void disturb(Real time) {
    if (options_.noise > 0) exact::disturb(s_, body_, time, noise_);
  }

  // Takes away the rounding of y: the lowest corner touches.
  void put_on_ground() {
    const auto r = methods::arms(body_, s_.theta);
    s_.y = -std::min(std::min(r[0].y, r[1].y), std::min(r[2].y, r[3].y));
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
      if (!carried_.lost() && !is_alone(hit.index[0], r, s_.y)) carried_.lose();
      collide_corner(hit.index[0], r);
    } else {
      carried_.lose();
      collide_side(hit, r);
    }
  }

  void collide_corner(int k, const Row<Arm<Real>, 4>& arms) {
    const Arm<Real>& r = arms[k];
    methods::Collision<Real> collision = methods::collision_of(s_, r, body_);
    const bool rests = is_cut(collision.v_n, cut_at(r));
    if (rests) carried_.lose();
    if (collision.v_n < 0) {
      if (rests) collision.epsilon = 0;
      const CornerImpulse<Real> p = methods::impact(collision, options_.law);
      if (!carried_.lost()) carried_.collide(k, arms, s_.theta, p.mode, options_.law);
      methods::apply_impulse(s_, r, p.n, p.t, body_.gyration_squared);
      if (p.mode == methods::ContactMode::sticks) s_.v_x = r.y * s_.omega;
    }
    if (rests && methods::normal_velocity(s_, r) < cut_at(r)) close(k, r);
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
    const Real epsilon = is_cut(approach, cut_at(r_1)) ? Real(0) : body_.epsilon;
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
    if (std::abs(s_.omega) < slow()) s_.omega = 0;  // it leaves flat, but for rounding
    const Real cut = cut_at(r_1);
    const Real after_1 = methods::normal_velocity(s_, r_1);
    const Real after_2 = methods::normal_velocity(s_, r_2);
    const Real v_t = s_.v_x - (r_1.y + r_2.y) / 2 * s_.omega;
    if (std::max(after_1, after_2) < cut && settles(v_t, cut)) {
      closed_ = hit;
      return;
    }
    // A corner stays closed if it was pressed without enough speed to bounce.
    const auto stays = [&](int i, Real after) {
      return after < cut && (approach >= 0 || (pressed[i] > 0 && after < cut / 100));
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
        methods::two_corners(r_1, r_2, body_.gyration_squared, u, u_t, body_.mu, P_0));
    push_side(r_1, r_2, p);
    return p.n;
  }

  void push_side(const Arm<Real>& r_1, const Arm<Real>& r_2, const SideImpulse<Real>& p) {
    methods::apply_impulse(s_, r_1, p.n[0], p.t / 2, body_.gyration_squared);
    methods::apply_impulse(s_, r_2, p.n[1], p.t / 2, body_.gyration_squared);
  }

  void expand(const Arm<Real>& r_1, const Arm<Real>& r_2, const Row<Real, 2>& p, Real epsilon) {
    methods::apply_impulse(s_, r_1, epsilon * p[0], Real(0), body_.gyration_squared);
    methods::apply_impulse(s_, r_2, epsilon * p[1], Real(0), body_.gyration_squared);
    press(r_1, r_2, {methods::normal_velocity(s_, r_1), methods::normal_velocity(s_, r_2)},
          epsilon * (p[0] + p[1]));
  }

  // Lays the square flat if the side, its corners at rest along n, stays on the ground: if both
  // are pressed while it slides with v_t, or once it has stopped, where cut is enough to stop it.
  bool settles(Real v_t, Real cut) {
    const auto pressed = [](const SideImpulse<Real>& f) { return f.n[0] > 0 && f.n[1] > 0; };
    const SideImpulse<Real> f = side_force(v_t);
    if (pressed(f)) {
      lay_flat(std::abs(v_t) > slow() ? (v_t > 0 ? 1 : -1) : sliding_under(f));
      return true;
    }
    if (std::abs(v_t) >= cut) return false;
    const SideImpulse<Real> stopped = side_force(Real(0));
    if (!pressed(stopped) || std::abs(stopped.t) >= most_friction(stopped)) return false;
    lay_flat(0);
    return true;
  }

  Real most_friction(const SideImpulse<Real>& f) const { return body_.mu * (f.n[0] + f.n[1]); }

  // The direction in which these forces let a side slide that does not move yet.
  int sliding_under(const SideImpulse<Real>& f) const {
    if (std::abs(f.t) < most_friction(f)) return 0;
    return f.t + body_.g_x > 0 ? 1 : -1;
  }

  // Lays the side on the ground, and gives it what is left of its impulses: those that take v_y and
  // omega away, with their friction. sigma is the direction in which it slides, 0 if it sticks.
  void lay_flat(int sigma) {
    const Real quarter = std::numbers::pi_v<Real> / 2;
    s_.theta = std::round(s_.theta / quarter) * quarter;
    s_.y = body_.half;
    const Real rest = Real(sigma) * body_.mu * s_.v_y, v_x = s_.v_x + rest;
    s_.v_x = sigma == 0 || (rest != 0 && Real(sigma) * v_x < 0) ? Real(0) : v_x;
    s_.v_y = s_.omega = 0;
    cuts_ = 0;
  }

  // The side's forces per unit of mass, with the square lying flat.
  SideImpulse<Real> side_force(Real v_t) const {
    const methods::TwoCorners<Real> k{{-body_.half, body_.half},
                                      -body_.half,
                                      body_.gyration_squared,
                                      {body_.g_y, body_.g_y},
                                      body_.g_x,
                                      body_.mu,
                                      0};
    if (std::abs(v_t) <= slow()) return methods::solve_two_corners(k);
    return methods::solve_side(k, v_t > 0 ? 1 : -1, false);
  }

  // Slower sliding than this is only the rounding error of an impact, and counts as none.
  Real slow() const {
    return 1000 * std::numeric_limits<Real>::epsilon() *
           (1 + std::abs(s_.v_x) + body_.rho * std::abs(s_.omega));
  }

  // A corner that leaves more slowly than this comes back at once. Where it hardly comes back,
  // since gravity or rotation lifts it, no bounce is left out. On a slope a square that is at rest
  // but for the cut may draw as much from it in each hop as its impacts take; so cuts that go on
  // are made larger.
  Real cut_at(const Arm<Real>& r) const {
    const Real falls = std::clamp(r.y * s_.omega * s_.omega - body_.g_y, Real(0), Real(1));
    return (cuts_ > 50 ? 100 : 1) * cut_ * falls;
  }

  // Whether restitution ends here: a corner that approaches like this would leave too slowly.
  bool is_cut(Real v_n, Real cut) {
    if (v_n < -1000 * cut_) cuts_ = 0;
    const bool ends = v_n > -cut || -v_n * body_.epsilon < cut;
    cuts_ += ends;
    return ends;
  }

  // Gives a corner what is left of its impulses, those that take its v_n away, with their friction.
  void stop_leaving(const Arm<Real>& r) {
    const methods::Collision<Real> k = methods::collision_of(s_, r, body_);
    const int sigma = std::abs(k.v_t) > slow() ? (k.v_t > 0 ? 1 : -1) : 0;
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
    methods::apply_impulse(s_, r, p, friction * p, body_.gyration_squared);
  }

  // Closes one corner: v_n is 0 from now on, and the mode is still to be found.
  void close(int k, const Arm<Real>& r) {
    closed_ = {};
    closed_.add(k);
    sliding_ = Sliding::unknown;
    stop_leaving(r);
    hold(k);
  }

  // Takes away the rounding of y and v_y at a corner on the ground, and of v_x if it sticks.
  void hold(int k) {
    const Arm<Real> r = methods::arms(body_, s_.theta)[k];
    s_.y = -r.y;
    s_.v_y = -r.x * s_.omega;
    if (sliding_ == Sliding::no) s_.v_x = r.y * s_.omega;
  }

  enum class Sliding { left = -1, no = 0, right = 1, unknown };

  // One corner on the ground.
  void follow_corner() {
    carried_.lose();
    const int k = closed_.index[0];
    const Arm<Real> r = methods::arms(body_, s_.theta)[k];
    if (sliding_ == Sliding::unknown && !find_mode(r)) return;
    const CornerMotion<Real> motion(body_, s_, r, direction_, order_);
    ++report_.series;
    const Real reach = std::min(motion.reach(Real(options_.tolerance)), last());
    const auto [guard, time] = motion.first_guard(reach);
    const bool ends = guard != Guard::none && time <= reach;
    advance(ends ? time : reach, report_.corner, [&](Real t) { return motion.at(t); });
    if (options_.noise > 0) {
      disturb(ends ? time : reach);
      hold(k);
    }
    if (ends) leave_mode(guard, k);
  }

  // Finds the mode by the LCP in accelerations; false if the corner doesn't stay.
  bool find_mode(const Arm<Real>& r) {
    const Real v_t = methods::tangential_velocity(s_, r);
    auto forces =
        methods::one_corner<Real>(r, body_.gyration_squared, body_.g_y - r.y * s_.omega * s_.omega,
                                  body_.g_x - r.x * s_.omega * s_.omega, body_.mu);
    if (std::abs(v_t) > slow()) {
      direction_ = v_t > 0 ? 1 : -1;
      if (forces.u_n < 0 && forces.a - Real(direction_) * forces.mu * forces.b <= 0) {
        jam(r);
        return false;
      }
    } else {
      const CornerImpulse<Real> f = methods::solve_one_corner(forces);
      direction_ = f.mode == methods::ContactMode::slides_right  ? 1
                   : f.mode == methods::ContactMode::slides_left ? -1
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
    const auto k = methods::one_corner<Real>(r, body_.gyration_squared, 0, 0, body_.mu);
    const Real v_t = methods::tangential_velocity(s_, r), D = k.a * k.c - k.b * k.b;
    methods::apply_impulse(s_, r, k.b * v_t / D, -k.a * v_t / D, body_.gyration_squared);
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
    carried_.lose();
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
    const bool stops = stop < last();
    const bool moves = std::abs(start.v_x) > slow() || std::abs(a) > slow();
    advance(stops ? stop : last(), report_.flat, [&](Real t) {
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
  Clock<Real> clock_;
  Noise noise_{options_.noise, options_.seed};
  CarriedMotions<Real> carried_;
  long events_ = 0;
  Real turns_ = 0, cut_ = 0;
  int order_ = 0;
  Real since_mark_ = 0;  // the time since stalls() last saw one go by, and the events
  int events_since_mark_ = 0;
  int cuts_ = 0;  // impacts whose restitution was cut since the last that was fast
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
  EventReport& written = report ? *report : unread;
  const Units units(params, start);
  std::vector<Real> scaled = times;
  for (Real& t : scaled) t /= Real(units.time);
  auto motions = Engine<Real>(units.in(params), units.in(start), scaled, options, written).run();
  for (Motion<Real>& s : motions) s = units.out(s);
  for (double* mode : {&written.flight, &written.corner, &written.flat}) *mode *= units.time;
  for (CarriedDistances& apart : written.distances) {
    apart.perturbed *= units.length;
    apart.finer *= units.length;
  }
  return motions;
}

template std::vector<Motion<double>> simulate_events(const Parameters&, const Motion<double>&,
                                                     const std::vector<double>&,
                                                     const EventOptions&, EventReport*);
template std::vector<Motion<long double>> simulate_events(const Parameters&,
                                                          const Motion<long double>&,
                                                          const std::vector<long double>&,
                                                          const EventOptions&, EventReport*);

}  // namespace bounce::exact
