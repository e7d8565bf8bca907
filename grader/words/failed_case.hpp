// What a check's report says of its failed case: by ./kit grade and by ./check.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace bounce::words {

inline constexpr double kDegree = 3.14159265358979323846 / 180;  // rad

using Rows = std::vector<std::vector<double>>;

// A number, vector or matrix of a question, or a parameter.
struct Value {
  std::string name;
  Rows rows;
  std::string unit;
};

// A wrong quantity; a scalar is one row of one number.
struct Quantity {
  std::string name, unit;
  Rows got, expected;
  std::vector<std::vector<bool>> right;  // for each entry
};

// What is asked: q, v or J, and the parameters that aren't the assignment's.
struct Question {
  std::vector<Value> input, parameters;
};

// A number on the way to the right answer, and the equation that it comes from.
struct OnTheWay {
  Value value;
  int equation = 0;
};

// The simplest case that is wrong, to be worked out on paper.
struct Smallest {
  std::optional<Question> before = {};  // asked first, where the program is right without it
  Question asked = {};
  Value expected = {};  // the quantity, and what is right
  Rows got = {};
  std::vector<OnTheWay> on_the_way = {};
};

// The wrong case of a check to report, or the one at which its program ended.
struct FailedCase {
  std::size_t cases = 0;     // of the check
  std::size_t wrong = 0;     // of these
  std::size_t ended_at = 0;  // how many were asked until the program ended, with the last; else 0
  bool again = false;        // it was right when it was asked before, in another order
  bool always_zero = false;  // each case is wrong, and every wrong number is 0
  std::string name;
  std::vector<Value> input;       // the question
  std::vector<Value> parameters;  // those that aren't the assignment's
  bool hidden = false;            // the expected answer is the course's
  std::string contact;            // what the corner does
  std::string sentence;           // what the numbers alone don't say
  std::vector<Quantity> quantities;
  std::optional<Smallest> smallest = {};
};

// To so many digits; what is only a rounding error of 0 as 0.
std::string number(double x, int digits);

// "30°"; empty if the angle is rounder in radians.
std::string in_degrees(double radians);

// "2 of 9 cases wrong", or "ended at case 3 of 9".
std::string counts(const FailedCase& failed);

// What was asked, what came, and what is right; of a hidden case this only if it is `shown`.
std::string lines(const FailedCase& failed, bool shown);

// What the corner does, and each wrong quantity beside the right one, its wrong entries marked.
std::string numbers(const FailedCase& failed, bool shown);

// The name of the case, and below it what is asked.
std::string question(const FailedCase& failed);

// on_paper.cpp: the smallest case in a sentence, unless it is the failed case itself; and below it,
// a line each, what leads to the answer:
//   smallest q = (0, 0, 30°), all else as in the assignment: phi = -0.136603 m is right, yours is
//   0.
//            r = (-0.0366025 m, -0.136603 m)  (eq. 5)
std::string on_paper(const Smallest& smallest, const FailedCase& failed);

// What came in place of numbers, as a line below the question.
std::string got(const std::string& sentence);

}  // namespace bounce::words
