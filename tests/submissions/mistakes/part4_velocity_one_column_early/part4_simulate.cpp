#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>

namespace bounce {

Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  Eigen::Matrix3Xd q(3, params.T), v(3, params.T);
  Vector3 q_t = q_0, v_t = v_0;
  for (int t = 0; t < params.T; ++t) {
    q.col(t) = q_t;
    const State next = step(q_t, v_t, params);
    q_t = next.q;
    v_t = next.v;
    v.col(t) = v_t;
  }
  return {q, v};
}

}  // namespace bounce
