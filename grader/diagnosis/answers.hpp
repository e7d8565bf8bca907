// A part's answers to all of its public cases, as lists of numbers. Known mistakes are recognised,
// and unknown ones described, by these numbers.
#pragma once

#include <string>
#include <vector>

#include "cases.hpp"
#include "messages.hpp"
#include "submission.hpp"

namespace bounce::tests {

// The answer to one question: numbers, or the text of an exception. Part 1: J and phi; part 2: V
// and p; matrices column by column. Part 3: q' - q - dt v', in which a wrong v' doesn't show, and
// v'. Part 4: q and v in a few columns of the trajectory.
struct Answer {
  Eigen::VectorXd numbers;
  std::string thrown;
};

// The columns of a trajectory that are compared, as far as it has them: enough to tell mistakes
// apart, and early enough that rounding errors haven't grown.
std::vector<int> known_columns(int T);

// The numbers of a result, as a frame has them.
template <class Result>
Eigen::VectorXd numbers_of(const Result& result) {
  frames::Frame frame;
  double* end = frame.values;
  frames::put(frame, end, result);
  return Eigen::Map<Eigen::VectorXd>(frame.values, end - frame.values);
}

// The numbers for the state after the step of a case.
Eigen::VectorXd numbers_of(const State& next, const Case& c);

// The numbers for these columns of a trajectory, q above v.
Eigen::VectorXd numbers_of(const Trajectory& trajectory);

// How many numbers of an answer belong together: all; of a trajectory, those of one column.
int numbers_together(int part);

// The part's file in the folders of public fixtures, found by the beginning of its name.
// Throws std::runtime_error if there is none.
std::filesystem::path public_file(int part, const std::string& folder = "");

// What a wrong part is asked: its public cases and the diagnostic questions, and at last the first
// ones again, in reverse order: so a program gives itself away that keeps something between calls,
// or reads what was never set. Cases whose
// parameters aren't the assignment's come first, so that a program which stores parameters in its
// first call is wrong in the next ones.
std::vector<Case> questions(int part);

// Registers how to call a part's function; the part's tests do so. Returns true.
using AskNumbers = Eigen::VectorXd (*)(submission::Asker&, const Case&);
bool register_call(int part, AskNumbers ask);

// The answers to all questions. Empty where the program ends before it has answered.
std::vector<Answer> answers(submission::Asker& asker, int part, const std::vector<Case>& questions);

}  // namespace bounce::tests
