// The layout in a frame of each part's arguments and result, for the runner, the given parts, the
// judge, and recorded answers. A new part adds put and take for its result, unless it is a number,
// a matrix, or a struct of two of these.
#pragma once

#include <tuple>

#include "frame.hpp"

namespace bounce::frames {

// A struct of two of them, such as Contact.
template <class Pair, class = std::enable_if_t<std::is_aggregate_v<Pair>>>
void put(Frame& frame, double*& values, const Pair& pair) {
  const auto& [first, second] = pair;
  put(frame, values, first);
  put(frame, values, second);
}

template <class Pair, class = std::enable_if_t<std::is_aggregate_v<Pair>>>
void take(const Frame& frame, const double*& values, Pair& pair) {
  auto& [first, second] = pair;
  take(frame, values, first);
  take(frame, values, second);
}

// Its columns follow the frame.
inline void put(Frame& frame, double*&, const Trajectory& trajectory) {
  frame.q_columns = trajectory.q.cols();
  frame.v_columns = trajectory.v.cols();
}

template <class... Arguments>
Frame question(std::uint32_t part, const Arguments&... arguments) {
  Frame frame;
  frame.part = part;
  double* values = frame.values;
  (put(frame, values, arguments), ...);
  return frame;
}

template <class Result>
Result result(const Frame& answer) {
  Result result;
  const double* values = answer.values;
  take(answer, values, result);
  return result;
}

// Calls a part's function with the question's arguments, and puts the result into `answer`, too.
template <class Result, class... Arguments>
Result answer(const Frame& question, Frame& answer, Result (*function)(const Arguments&...)) {
  std::tuple<Arguments...> arguments;
  const double* from = question.values;
  std::apply([&](Arguments&... each) { (take(question, from, each), ...); }, arguments);
  Result result = std::apply(function, arguments);
  double* to = answer.values;
  put(answer, to, result);
  return result;
}

}  // namespace bounce::frames

namespace bounce::runner {

// An earlier part's result for this frame's arguments, for a part that is given; main sets it. A
// runner asks the judge (channel.hpp), and a student's own build looks into recorded answers
// (tests/parts/linked/given.cpp). Throws std::runtime_error if there is none.
inline frames::Frame (*ask_earlier_part)(frames::Frame callback) = nullptr;

}  // namespace bounce::runner
