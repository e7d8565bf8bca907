// The protocol between the judge and a runner: frames of a fixed size, on two pipes of their own.
// What a submission prints goes elsewhere and is never taken for an answer.
//
//   judge -> runner  a question: part, params, arguments
//   runner -> judge  an answer, or a callback: the arguments of a call to a given part
//   judge -> runner  the reply to a callback
//
// The judge trusts nothing in a runner's frame: it checks kind, part, number and the counts before
// it uses them.
#pragma once

#include <bounce/types.hpp>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>

namespace bounce::frames {

inline constexpr int kQuestions = 3;  // the runner reads questions and replies here
inline constexpr int kAnswers = 4;    // and writes answers and callbacks here
inline constexpr std::uint32_t kMagic = 0x31424E42;
inline constexpr int kState = 6, kStates = 3;  // a state's numbers; states in a reply about a step

enum class Kind : std::uint32_t { question = 1, answer, callback, threw, out_of_memory, absent };

struct Frame {
  std::uint32_t magic = kMagic;
  Kind kind = Kind::question;
  std::uint32_t part = 0;  // 1 to 4
  std::uint32_t unused = 0;
  std::uint64_t number = 0;                   // an answer carries the number of its question
  std::int64_t q_columns = 0, v_columns = 0;  // part 4; see columns_at_hand
  double scene[9] = {};                       // l, m, mu, epsilon, g, dt, delta
  std::int64_t T = 0;      // of the judge's reply about a step: how many it holds
  double values[20] = {};  // arguments or results, column by column
  char text[160] = {};     // what(), if the submission threw
};
static_assert(std::is_trivially_copyable_v<Frame>);

// Write or read one argument or result, and move `values` on by as many numbers as it has.
inline void put(Frame& frame, double*&, const Parameters& p) {
  const double scene[9] = {p.l, p.m, p.mu, p.epsilon, p.g(0), p.g(1), p.g(2), p.dt, p.delta};
  std::memcpy(frame.scene, scene, sizeof scene);
  frame.T = p.T;
}

inline void take(const Frame& frame, const double*&, Parameters& p) {
  const double* s = frame.scene;
  p = {s[0], s[1], s[2], s[3], {s[4], s[5], s[6]}, s[7], s[8], static_cast<int>(frame.T)};
}

inline void put(Frame&, double*& values, double x) { *values++ = x; }
inline void take(const Frame&, const double*& values, double& x) { x = *values++; }

template <class Derived>
void put(Frame&, double*& values, const Eigen::DenseBase<Derived>& matrix) {
  const auto& m = matrix.derived();
  std::memcpy(values, m.data(), sizeof(double) * static_cast<std::size_t>(m.size()));
  values += m.size();
}

template <class Derived>
void take(const Frame&, const double*& values, Eigen::DenseBase<Derived>& matrix) {
  auto& m = matrix.derived();
  std::memcpy(m.data(), values, sizeof(double) * static_cast<std::size_t>(m.size()));
  values += m.size();
}

// The text of what is thrown and has none.
inline constexpr char kNoException[] = "something that isn't a std::exception";

inline void put_text(Frame& frame, const char* text) {
  std::strncpy(frame.text, text, sizeof frame.text - 1);
}

inline std::string text(const Frame& frame) {
  return std::string(frame.text, ::strnlen(frame.text, sizeof frame.text));
}

}  // namespace bounce::frames
