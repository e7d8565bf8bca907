#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>

namespace bounce {

Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  Eigen::Matrix3Xd q(3, params.T), v(3, params.T);
  State now{q_0, v_0};
  for (int t = 0;; ++t) {
    q.col(t) = now.q;
    v.col(t) = now.v;
    if (t + 1 >= params.T) break;
    now = step(now.q, now.v, params);
  }
  return {q, v};
}

}  // namespace bounce
