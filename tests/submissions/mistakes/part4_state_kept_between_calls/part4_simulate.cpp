#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>

namespace bounce {

Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  static State current{q_0, v_0};

  Trajectory trajectory{Eigen::Matrix3Xd(3, params.T), Eigen::Matrix3Xd(3, params.T)};
  for (int t = 0; t < params.T; ++t) {
    trajectory.q.col(t) = current.q;
    trajectory.v.col(t) = current.v;
    current = step(current.q, current.v, params);
  }
  return trajectory;
}

}  // namespace bounce
