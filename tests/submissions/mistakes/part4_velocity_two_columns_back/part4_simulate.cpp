#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>

namespace bounce {

Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  Trajectory trajectory{Eigen::Matrix3Xd::Zero(3, params.T), Eigen::Matrix3Xd::Zero(3, params.T)};
  Vector3 q = q_0, v = v_0, v_next = v_0;
  for (int t = 0; t < params.T; ++t) {
    trajectory.q.col(t) = q;
    trajectory.v.col(t) = v_next;
    const State next = step(q, v, params);
    v = v_next;
    q = next.q;
    v_next = next.v;
  }
  return trajectory;
}

}  // namespace bounce
