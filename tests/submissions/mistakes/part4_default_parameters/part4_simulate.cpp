#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>

namespace bounce {

Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  const int T = params.T;
  Trajectory trajectory;
  trajectory.q = Eigen::Matrix3Xd(3, T);
  trajectory.v = Eigen::Matrix3Xd(3, T);
  trajectory.q.col(0) = q_0;
  trajectory.v.col(0) = v_0;
  for (int t = 0; t < T - 1; ++t) {
    State next = step(trajectory.q.col(t), trajectory.v.col(t), Parameters());
    trajectory.q.col(t + 1) = next.q;
    trajectory.v.col(t + 1) = next.v;
  }
  return trajectory;
}

}  // namespace bounce
