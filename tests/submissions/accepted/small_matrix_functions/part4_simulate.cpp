#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>

namespace bounce {

Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  // both histories in one 6xT matrix, split at the end
  Eigen::Matrix<double, 6, Eigen::Dynamic> X(6, params.T);
  X.col(0) << q_0, v_0;
  for (int t = 1; t < params.T; ++t) {
    const State s = step(X.col(t - 1).head<3>(), X.col(t - 1).tail<3>(), params);
    X.col(t) << s.q, s.v;
  }
  return {X.topRows<3>(), X.bottomRows<3>()};
}

}  // namespace bounce
