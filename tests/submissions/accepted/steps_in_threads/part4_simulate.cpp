#include <future>
#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>

namespace bounce {

Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  Trajectory trajectory{Eigen::Matrix3Xd(3, params.T), Eigen::Matrix3Xd(3, params.T)};
  State state{q_0, v_0};
  for (int t = 0; t < params.T; ++t) {  // eq. (15): T columns are T - 1 steps
    if (t > 0) state = std::async(std::launch::async, [&] { return step(state.q, state.v, params); }).get();
    trajectory.q.col(t) = state.q;
    trajectory.v.col(t) = state.v;
  }
  return trajectory;
}

}  // namespace bounce
