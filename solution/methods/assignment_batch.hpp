// The assignment's scheme for many squares at once, one array a number, so that the compiler can
// use vector instructions: every case of one_corner.hpp is computed without a branch, and one is
// selected. All squares share the parameters.
#pragma once

#include <vector>

#include "assignment.hpp"

namespace bounce::methods {

class AssignmentBatch {
 public:
  AssignmentBatch(const Parameters& params, const std::vector<Motion<double>>& starts);
  void steps(long n);
  Motion<double> motion(std::size_t i) const;
  std::size_t size() const { return x_.size(); }

 private:
  void step();
  void take_anew(std::size_t i);

  StepConstants k_;
  std::vector<double> x_, y_, theta_, v_x_, v_y_, omega_, cosine_, sine_;
  int fresh_ = 0;  // steps until all cosines and sines are taken from theta again
};

}  // namespace bounce::methods
