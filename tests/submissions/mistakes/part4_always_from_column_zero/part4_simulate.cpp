#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>

namespace bounce {

Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  Eigen::Matrix3Xd q(3, params.T), v(3, params.T);
  q.col(0) = q_0;
  v.col(0) = v_0;
  for (int t = 1; t < params.T; ++t) {
    State s = step(q_0, v_0, params);
    q.col(t) = s.q;
    v.col(t) = s.v;
  }
  return {q, v};
}

}  // namespace bounce
