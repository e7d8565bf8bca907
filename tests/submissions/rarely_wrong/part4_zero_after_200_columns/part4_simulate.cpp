#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>

namespace bounce {

Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  Trajectory all;
  all.q = Eigen::Matrix3Xd::Zero(3, params.T);
  all.v = Eigen::Matrix3Xd::Zero(3, params.T);
  all.q.col(0) = q_0;
  all.v.col(0) = v_0;
  for (int t = 1; t < params.T && t < 200; t++) {
    State next = step(all.q.col(t - 1), all.v.col(t - 1), params);
    all.q.col(t) = next.q;
    all.v.col(t) = next.v;
  }
  return all;
}

}  // namespace bounce
