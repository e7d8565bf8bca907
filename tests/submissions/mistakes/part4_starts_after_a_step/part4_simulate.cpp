#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>

namespace bounce {

Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  Trajectory trajectory{Eigen::Matrix3Xd(3, params.T), Eigen::Matrix3Xd(3, params.T)};
  Vector3 q = q_0;
  Vector3 v = v_0;
  for (int t = 0; t < params.T; ++t) {
    const State next = step(q, v, params);
    q = next.q;
    v = next.v;
    trajectory.q.col(t) = q;
    trajectory.v.col(t) = v;
  }
  return trajectory;
}

}  // namespace bounce
