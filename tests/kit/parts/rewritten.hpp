// The four parts written again, with a switch for each known mistake, to test recognition in code
// other than the gallery's, and with two mistakes in one program.
#pragma once

#include <optional>
#include <set>
#include <string>

#include "../../parts/cases.hpp"

namespace bounce::tests {

// A program with these mistakes, written in one of two ways: with matrices or number by number,
// with a loop or by recursion. Part 1 knows four ways to find the lowest corner. A mistake that
// isn't known here changes nothing.
class Rewritten {
 public:
  static constexpr int kWays[] = {4, 2, 2, 2};

  Rewritten(std::set<std::string> mistakes, int way) : mistakes_(std::move(mistakes)), way_(way) {}

  // Part 1 to 4, in the numbers of answers.hpp.
  Eigen::VectorXd answer(int part, const Case& c);

 private:
  bool has(const std::string& mistake) const { return mistakes_.count(mistake) > 0; }
  Eigen::VectorXd part1(const Case& c);
  Eigen::VectorXd part2(const Case& c) const;
  Eigen::VectorXd part3(const Case& c);
  Eigen::VectorXd part4(const Case& c);

  double half_side(const Parameters& params) const;
  int lowest(const Eigen::Matrix<double, 2, 4>& r, double theta) const;
  Eigen::Vector3d contact_force(const Contact& contact, const Case& c) const;
  bool touches(const Contact& contact, const Case& c, const Parameters& params) const;
  double lift(bool touching, double phi, const Parameters& params) const;

  State state_after(const std::vector<State>& states, const Parameters& params) const;
  void add_states(std::vector<State>& states, std::size_t count, const Parameters& params) const;

  std::set<std::string> mistakes_;
  int way_;
  std::optional<Parameters> first_;  // of the first question
  std::optional<State> state_;       // at the end of the last trajectory
  std::vector<State> columns_;       // of all trajectories
};

}  // namespace bounce::tests
