#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>

namespace bounce {

Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  Trajectory out{Eigen::Matrix3Xd::Zero(3, params.T), Eigen::Matrix3Xd::Zero(3, params.T)};
  out.q.col(0) = q_0;
  out.v.col(0) = v_0;
  for (int t = 1; t < params.T - 1; ++t) {
    const State next = step(out.q.col(t - 1), out.v.col(t - 1), params);
    out.q.col(t) = next.q;
    out.v.col(t) = next.v;
  }
  return out;
}

}  // namespace bounce
