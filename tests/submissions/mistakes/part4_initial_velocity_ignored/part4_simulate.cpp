#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>

namespace bounce {

Trajectory simulate(const Vector3& q_0, const Vector3& /*v_0*/, const Parameters& params) {
  Trajectory out;
  out.q = Eigen::Matrix3Xd::Zero(3, params.T);
  out.v = Eigen::Matrix3Xd::Zero(3, params.T);
  out.q.col(0) = q_0;
  for (int t = 0; t + 1 < params.T; ++t) {
    const auto [q, v] = step(out.q.col(t), out.v.col(t), params);
    out.q.col(t + 1) = q;
    out.v.col(t + 1) = v;
  }
  return out;
}

}  // namespace bounce
