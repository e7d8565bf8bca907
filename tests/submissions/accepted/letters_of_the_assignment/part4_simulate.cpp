#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>

namespace bounce {

Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  const int T = params.T;
  Eigen::Matrix3Xd q(3, T);
  Eigen::Matrix3Xd v(3, T);

  // eq. (15)
  q.col(0) = q_0;
  v.col(0) = v_0;
  for (int t = 0; t <= T - 2; ++t) {
    const State s = step(q.col(t), v.col(t), params);
    q.col(t + 1) = s.q;
    v.col(t + 1) = s.v;
  }
  return {q, v};
}

}  // namespace bounce
