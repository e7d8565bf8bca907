#include "simulated.hpp"

#include <bounce/part4_simulate.hpp>
#include <stdexcept>
#include <string>

namespace bounce {
namespace {

// Why q can't be shown; empty if it can.
std::string missing(const Eigen::Matrix3Xd& q, const Parameters& params) {
  if (q.cols() != params.T) {
    return "simulate returned " + std::to_string(q.cols()) + " columns and " +
           std::to_string(params.T) + " are due, so please " +
           (q.cols() == 0 ? "fill in" : "look at the size in") + " src/part4_simulate.cpp";
  }
  for (Eigen::Index t = 0; t < q.cols(); ++t) {
    if (q.col(t).allFinite()) continue;
    return "column " + std::to_string(t) +
           " of q holds NaN or infinity, so please look at what step makes of the column before";
  }
  if (q.cols() > 1 && q.rightCols(q.cols() - 1).isZero(0))
    return "step returned only zeros, so please fill in src/part3_step.cpp";
  return "";
}

}  // namespace

Trajectory simulated(const State& start, const Parameters& params) {
  Trajectory trajectory = simulate(start.q, start.v, params);
  const std::string sentence = missing(trajectory.q, params);
  if (!sentence.empty()) throw std::runtime_error("there is nothing to show yet: " + sentence);
  return trajectory;
}

}  // namespace bounce
