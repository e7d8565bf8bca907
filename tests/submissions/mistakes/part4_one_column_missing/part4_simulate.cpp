#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>
#include <vector>

namespace bounce {

Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  std::vector<State> states{{q_0, v_0}};
  for (int t = 1; t < params.T - 1; ++t) {
    states.push_back(step(states.back().q, states.back().v, params));
  }

  const int columns = params.T - 1;
  Trajectory trajectory{Eigen::Matrix3Xd(3, columns), Eigen::Matrix3Xd(3, columns)};
  for (int t = 0; t < columns; ++t) {
    trajectory.q.col(t) = states[static_cast<std::size_t>(t)].q;
    trajectory.v.col(t) = states[static_cast<std::size_t>(t)].v;
  }
  return trajectory;
}

}  // namespace bounce
