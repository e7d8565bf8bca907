#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>

namespace bounce {

Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  Trajectory out{Eigen::Matrix3Xd(3, params.T), Eigen::Matrix3Xd(3, params.T)};
  out.q.col(0) = q_0;
  out.v.col(0) = v_0;
  for (int t = 0; t < params.T - 1; ++t) {
    const State next = step(out.q.col(t), out.v.col(t), params);
    out.q.col(t + 1) = next.q;
    out.v.col(t + 1) = next.v;
  }
  return out;
}

}  // namespace bounce
