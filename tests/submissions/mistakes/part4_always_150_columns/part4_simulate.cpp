#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>

namespace bounce {

constexpr int STEPS = 150;

Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  Eigen::Matrix<double, 3, STEPS> q;
  Eigen::Matrix<double, 3, STEPS> v;
  q.col(0) = q_0;
  v.col(0) = v_0;
  for (int t = 1; t < STEPS; ++t) {
    const State s = step(q.col(t - 1), v.col(t - 1), params);
    q.col(t) = s.q;
    v.col(t) = s.v;
  }
  return {q, v};
}

}  // namespace bounce
