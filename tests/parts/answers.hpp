// What a part answers to all of its public cases, as lists of numbers: this is what known mistakes
// are recognised by, and what is said of an unknown one.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cases.hpp"

namespace bounce::tests {

// The answer to one question: numbers, or the words of what was thrown in their place. Part 1
// answers J and phi, part 2 V and p, a matrix column by column; part 3 the move q' - q - dt v', in
// which a wrong v' doesn't show, and v'; part 4 q and v in a few columns of the trajectory.
struct Answer {
  Eigen::VectorXd numbers;
  std::string thrown;
};

// A trajectory is known in these columns, as far as it has them: enough to tell mistakes apart, and
// early enough that rounding hasn't grown.
std::vector<int> known_columns(int T);

// The numbers of the state after the step from a case's.
Eigen::VectorXd numbers_of(const State& next, const Case& c);

// The numbers of a trajectory in these columns, q above v.
Eigen::VectorXd numbers_of(const Trajectory& trajectory);

// Numbers of an answer that belong together: all, and of a trajectory those of one column.
int numbers_together(int part);

// The part's file in the folders of public fixtures, by the beginning of its name.
std::optional<std::filesystem::path> public_file(int part, const std::string& folder = "");

// The public cases of a part. The last of the file come first: their parameters aren't the
// assignment's, so that what a program keeps from its first question shows in the next ones.
std::vector<Case> questions(int part);

// How a part's function is asked; the part's tests say it. Returns true.
bool is_asked_by(int part, const std::function<Eigen::VectorXd(const Case&)>& ask);

// The answers to all questions. Empty where the program ends before it has answered.
std::vector<Answer> answers(int part, const std::vector<Case>& questions);

}  // namespace bounce::tests
