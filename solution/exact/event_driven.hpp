// The exact motion, from event to event; each phase in between in closed form or as a power series.
//
//   flight      exact parabola; the first contact guaranteed                    first_contact.hpp
//   impact      of one corner or of two, by Newton's law; what stays            ground.hpp
//   one corner  sticks or slides: power series, their guards polynomials        series.hpp
//   flat        a side on the ground: rests, or slides with constant deceleration
//
// Units: all of it works in a length near l and a time near sqrt(l / g), both powers of two, so
// that its tolerances mean the same at every scale and no number is rounded on the way in or out.
// theta is within half a turn, and whole turns are counted apart. Times are counted from the last
// event.
//
// Which mode follows is an LCP in accelerations, the same as that in impulses with a_n and a_t in
// place of u_n and u_t (Lotstedt 1981; Glocker & Studer 2005, "Formulation and preparation for
// numerical evaluation of linear complementarity systems in dynamics", Multibody System Dynamics
// 13). It may have no solution where a <= mu |b| and the corner slides into the ground. Then the
// corner jams: an impulse acts although v_n = 0, which solves the LCP in impulses (Moreau 1988,
// "Unilateral contact and dry friction in finite freedom dynamics", on frictional catastrophes).
#pragma once

#include <vector>

#include "../methods/square.hpp"

namespace bounce::study {

// The part of the whole model that a method may use: at most `corners` touch at once, with or
// without friction. The ladder of models consists of these; 0 corners is free flight through the
// ground.
struct Model {
  int corners = 2;
  bool friction = true;
};

struct EventOptions {
  Model model = {};
  double cut = 1e-6;         // in units of sqrt(l g), within a factor of 2
  double tolerance = 1e-15;  // of one step of a series, in rad and in units of l / sqrt 2
  double touching = 1e-13;  // in units of l, within a factor of 2: corners this near touch together
  long most_events = 0;     // gives up after these; 0: never
  // A shadow: random changes of this relative size at each event, as rounding makes them. A square
  // that is exactly parallel to the ground and does not turn stays so.
  double noise = 0;
  unsigned seed = 1;
};

struct EventReport {
  long impacts = 0;
  bool stays = false;    // at some time, one corner or a side stays on the ground
  bool stalled = false;  // events went on without an end at one time; what follows is not computed
};

// The motion at each of the times, which ascend from >= 0. Shorter than `times` if it stalled or
// gave up. Real is double or long double.
template <class Real>
std::vector<Motion<Real>> simulate_events(const Parameters& params, const Motion<Real>& start,
                                          const std::vector<Real>& times,
                                          const EventOptions& options,
                                          EventReport* report = nullptr);

}  // namespace bounce::study
