// The layout in a frame of each part's arguments and result, for the runner, its given parts and
// the judge. A new part adds its function's name, and put and take for its result.
#pragma once

#include "frame.hpp"

namespace bounce::frames {

inline constexpr const char* kFunctions[] = {
    "bounce::get_contacts",
    "bounce::form_lcp",
    "bounce::step",
    "bounce::simulate",
};

inline void put(Frame& frame, const Contact& contact) {
  put(frame, contact.J);
  frame.values[6] = contact.phi;
}

inline void take(const Frame& frame, Contact& contact) {
  take(frame, contact.J);
  contact.phi = frame.values[6];
}

inline void put(Frame& frame, const Lcp& lcp) { put(frame, lcp.V, lcp.p); }
inline void take(const Frame& frame, Lcp& lcp) { take(frame, lcp.V, lcp.p); }

inline void put(Frame& frame, const State& state) { put(frame, state.q, state.v); }
inline void take(const Frame& frame, State& state) { take(frame, state.q, state.v); }

template <class... Arguments>
Frame question(std::uint32_t part, const Parameters& params, const Arguments&... arguments) {
  Frame frame;
  frame.part = part;
  put(params, frame);
  put(frame, arguments...);
  return frame;
}

template <class Result>
Result result(const Frame& answer) {
  Result result;
  take(answer, result);
  return result;
}

// Calls a part's function with the question's arguments, and puts the result into `answer`.
template <class Result, class A>
void answer(const Frame& question, Frame& answer, Result (*function)(const A&, const Parameters&)) {
  A a;
  take(question, a);
  put(answer, function(a, parameters(question)));
}

template <class Result, class A, class B>
void answer(const Frame& question, Frame& answer,
            Result (*function)(const A&, const B&, const Parameters&)) {
  A a;
  B b;
  take(question, a, b);
  put(answer, function(a, b, parameters(question)));
}

}  // namespace bounce::frames
