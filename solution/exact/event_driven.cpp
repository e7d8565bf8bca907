#include "event_driven.hpp"

#include <algorithm>
#include <limits>
#include <numbers>
#include <optional>

#include "first_contact.hpp"
#include "ground.hpp"
#include "noise.hpp"
#include "series.hpp"
#include "units.hpp"

namespace bounce::study {
namespace {

template <class Real>
class Engine {
 public:
  Engine(const Parameters& params, const Motion<Real>& start, const std::vector<Real>& times,
         const EventOptions& options, EventReport& report)
      : body_(params), s_(start), times_(times), options_(options), report_(report) {
    if (!options.model.friction) body_.mu = 0;
    set_turns_apart();
    order_ = std::clamp(int(4 - std::log(options.tolerance) / 2), 6, kMaxOrder);
  }

  std::vector<Motion<Real>> run() {
    samples_.reserve(times_.size());
    collide();
    while (samples_.size() < times_.size()) {
      report_.stalled = stalls();
      if (report_.stalled || (options_.most_events > 0 && events_++ >= options_.most_events)) break;
      closed_.count == 0 ? fly_on() : closed_.count == 1 ? follow_corner() : follow_side();
    }
    return std::move(samples_);
  }

 private:
  // Whether a thousand events have gone by in less time than a few bounces as low as the cut take.
  bool stalls() {
    if (since_mark_ > 100 * Real(options_.cut)) {
      since_mark_ = 0;
      events_since_mark_ = 0;
    }
    return ++events_since_mark_ > 1000;
  }

  // The time until the last sample.
  Real last() const { return clock_.until(times_.back()); }

  // Moves on by `time`, taking samples on the way; at(t) is the motion t later than now.
  template <class At>
  void advance(Real time, const At& at) {
    while (samples_.size() < times_.size()) {
      const Real later = clock_.until(times_[samples_.size()]);
      if (!(later <= time)) break;
      samples_.push_back(at(later));
      samples_.back().theta += turns_ * 2 * std::numbers::pi_v<Real>;
    }
    s_ = at(time);
    set_turns_apart();
    clock_.advance(time);
    since_mark_ += time;
  }

  // Keeps theta within half a turn.
  void set_turns_apart() {
    if (std::abs(s_.theta) <= std::numbers::pi_v<Real>) return;
    const Real rest = std::atan2(std::sin(s_.theta), std::cos(s_.theta));
    turns_ += std::round((s_.theta - rest) / (2 * std::numbers::pi_v<Real>));
    s_.theta = rest;
  }

  void fly_on() {
    const Motion<Real> start = s_;
    const Real last = this->last();
    const Real above =
        options_.model.corners == 0 ? last : std::min(time_above(start, body_), last);
    const NearFlight<Real> flight =
        above > 0 ? NearFlight<Real>{above, false} : first_contact(start, body_, last);
    advance(flight.time, [&](Real t) { return fly(start, body_, t); });
    if (flight.contact) {
      if (options_.noise > 0) disturb(s_, body_, flight.time, noise_);
      put_on_ground();
      collide();
    } else if (above > 0 && above < last) {
      s_.y = body_.rho;
    }
  }

  // Takes away the rounding of y: the lowest corner touches.
  void put_on_ground() { s_.y = height_on_ground(body_.half, s_.theta); }

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
    const auto v_n = [&](int i) { return normal_velocity(s_, r[hit.index[i]]); };
    if (hit.count == 2 && options_.model.corners < 2 && v_n(1) < v_n(0))
      hit.index[0] = hit.index[1];
    hit.count = std::min(hit.count, options_.model.corners);
    return hit;
  }

  // The end of a flight.
  void collide() {
    const auto r = arms(body_, s_.theta);
    collide(touching(r), r);
  }

  // The end of one corner's motion: its neighbour lands. Both touch, whatever the heights say: they
  // are as far from 0 as the series are from the truth, which may be more than what touches.
  void land(int k, int neighbour) {
    collide({2, {std::min(k, neighbour), std::max(k, neighbour)}}, arms(body_, s_.theta));
  }

  // The impact of all corners that touch. Corners that are pressed and don't leave stay closed.
  void collide(const Corners& touching, const Row<Arm<Real>, 4>& r) {
    const Corners hit = within_model(touching, r);
    closed_ = {};
    if (hit.count == 0) return;
    ++report_.impacts;
    closed_ = ground_.collide(s_, hit, r);
    if (closed_.count == 1) begin(closed_.index[0]);
  }

  // The corner stays on the ground from now on; its mode is still to be found.
  void begin(int k) {
    sliding_.reset();
    hold(k);
  }

  // Takes away the rounding of y and v_y at a corner on the ground, and of v_x if it sticks.
  void hold(int k) {
    const Arm<Real> r = arms(body_, s_.theta)[k];
    s_.y = -r.y;
    s_.v_y = -r.x * s_.omega;
    if (sliding_ == 0) s_.v_x = r.y * s_.omega;
  }

  // One corner on the ground.
  void follow_corner() {
    report_.stays = true;
    const int k = closed_.index[0];
    const Arm<Real> r = arms(body_, s_.theta)[k];
    if (!sliding_ && !find_mode(r)) return;
    const CornerMotion<Real> motion(body_, s_, r, *sliding_, order_);
    const Real reach = std::min(motion.reach(Real(options_.tolerance)), last());
    const auto [guard, time] = motion.first_guard(reach);
    const bool ends = guard != Guard::none && time <= reach;
    advance(ends ? time : reach, [&](Real t) { return motion.at(t); });
    if (options_.noise > 0) {
      disturb(s_, body_, ends ? time : reach, noise_);
      hold(k);
    }
    if (ends) leave_mode(guard, k);
  }

  // Finds the mode by the LCP in accelerations; false if the corner doesn't stay.
  bool find_mode(const Arm<Real>& r) {
    const Real v_t = tangential_velocity(s_, r);
    const auto forces =
        one_corner<Real>(r, body_.gyration_squared, body_.g_y - r.y * s_.omega * s_.omega,
                         body_.g_x - r.x * s_.omega * s_.omega, body_.mu);
    int sigma = v_t > 0 ? 1 : -1;
    if (std::abs(v_t) > slow(s_, body_)) {
      if (forces.u_n < 0 && forces.a - Real(sigma) * forces.mu * forces.b <= 0) {
        jam(r);
        return false;
      }
    } else {
      const auto mode = solve_one_corner(forces).mode;
      sigma = (mode == ContactMode::slides_right) - (mode == ContactMode::slides_left);
      s_.v_x = r.y * s_.omega;
    }
    if (forces.u_n >= 0) closed_ = {};
    sliding_ = sigma;
    return closed_.count == 1;
  }

  // The impact without approach that stops the sliding corner.
  void jam(const Arm<Real>& r) {
    const auto k = one_corner<Real>(r, body_.gyration_squared, 0, 0, body_.mu);
    const Real v_t = tangential_velocity(s_, r), D = k.a * k.c - k.b * k.b;
    apply_impulse(s_, r, k.b * v_t / D, -k.a * v_t / D, body_.gyration_squared);
    s_.v_x = r.y * s_.omega;
  }

  void leave_mode(Guard guard, int k) {
    switch (guard) {
      case Guard::lands_left:  // each arm is the one before, turned by a right angle
      case Guard::lands_right:
        return land(k, (k + (guard == Guard::lands_left ? 3 : 1)) % 4);
      case Guard::lifts:
        closed_ = {};
        return;
      case Guard::stops_sliding:
        s_.v_x = arms(body_, s_.theta)[k].y * s_.omega;
        return sliding_.reset();
      case Guard::slips_right:
      case Guard::slips_left:
        sliding_ = guard == Guard::slips_right ? 1 : -1;
        return;
      case Guard::none:
        return;
    }
  }

  // A side on the ground. Forces are constant until sliding stops.
  void follow_side() {
    report_.stays = true;
    const SideImpulse<Real> f = side_force(s_, body_, s_.v_x);
    if (!(f.n[0] > 0 && f.n[1] > 0)) {  // it tips over the corner that is pressed, or lifts off
      const auto r = arms(body_, s_.theta);
      const bool right = f.n[1] > f.n[0];
      const int k = closed_.index[(r[closed_.index[1]].x > 0) == right ? 1 : 0];
      closed_ = {f.n[0] > 0 || f.n[1] > 0 ? 1 : 0, {k}};
      if (closed_.count == 0) return;
      ground_.stop_leaving(s_, r[k]);
      return begin(k);
    }
    const Motion<Real> start = s_;
    const Real a = f.t + body_.g_x;
    const Real stop = start.v_x * a < 0 ? -start.v_x / a : std::numeric_limits<Real>::infinity();
    const bool stops = stop < last();
    const bool moves = std::abs(start.v_x) > slow(s_, body_) || std::abs(a) > slow(s_, body_);
    advance(stops ? stop : last(), [&](Real t) {
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
  Ground<Real> ground_{body_, Real(options_.cut)};
  long events_ = 0;
  Real turns_ = 0;
  int order_ = 0;
  Real since_mark_ = 0;  // the time since stalls() last saw one go by, and the events
  int events_since_mark_ = 0;
  Corners closed_;
  std::optional<int> sliding_;  // sigma of the corner on the ground, once it is known
};

}  // namespace

template <class Real>
std::vector<Motion<Real>> simulate_events(const Parameters& params, const Motion<Real>& start,
                                          const std::vector<Real>& times,
                                          const EventOptions& options, EventReport* report) {
  EventReport unread;
  const Units units(params, start);
  std::vector<Real> scaled = times;
  for (Real& t : scaled) t /= Real(units.time);
  auto motions =
      Engine<Real>(units.in(params), units.in(start), scaled, options, report ? *report : unread)
          .run();
  for (Motion<Real>& s : motions) s = units.out(s);
  return motions;
}

template Motions simulate_events(const Parameters&, const Motion<double>&,
                                 const std::vector<double>&, const EventOptions&, EventReport*);
template std::vector<Motion<long double>> simulate_events(const Parameters&,
                                                          const Motion<long double>&,
                                                          const std::vector<long double>&,
                                                          const EventOptions&, EventReport*);

}  // namespace bounce::study
