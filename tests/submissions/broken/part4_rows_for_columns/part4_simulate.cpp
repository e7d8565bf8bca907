#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>

namespace bounce {

Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  Eigen::MatrixXd q(params.T, 3), v(params.T, 3);
  State state{q_0, v_0};
  for (int t = 0; t < params.T; ++t) {
    q.row(t) = state.q.transpose();
    v.row(t) = state.v.transpose();
    state = step(state.q, state.v, params);
  }
  Trajectory trajectory;
  trajectory.q = q;
  trajectory.v = v;
  return trajectory;
}

}  // namespace bounce
