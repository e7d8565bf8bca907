#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>

namespace bounce {

Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  Trajectory trajectory{Eigen::Matrix3Xd::Zero(3, params.T), Eigen::Matrix3Xd::Zero(3, params.T)};
  trajectory.q.col(0) = q_0;
  trajectory.v.col(0) = v_0;

  Vector3 v = v_0;
  for (int t = 1; t < params.T; ++t) {
    const State next = step(trajectory.q.col(t - 1), v, params);
    trajectory.q.col(t) = next.q;
    v = next.v;
  }
  return trajectory;
}

}  // namespace bounce
