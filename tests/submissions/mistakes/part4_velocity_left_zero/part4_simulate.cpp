#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>

namespace bounce {

Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  Eigen::Matrix3Xd q = Eigen::Matrix3Xd::Zero(3, params.T);
  Eigen::Matrix3Xd v = Eigen::Matrix3Xd::Zero(3, params.T);
  State now{q_0, v_0};
  q.col(0) = now.q;
  for (int t = 1; t < params.T; t++) {
    now = step(now.q, now.v, params);
    q.col(t) = now.q;
  }
  return Trajectory{q, v};
}

}  // namespace bounce
