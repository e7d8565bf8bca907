#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>

namespace bounce {

Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  Trajectory trajectory{Eigen::Matrix3Xd(3, params.T), Eigen::Matrix3Xd(3, params.T)};
  State state{q_0, v_0};
  bool touched = false;
  for (int t = 0; t < params.T; ++t) {
    const Vector3 before = state.v;
    if (t > 0 && !touched) {
      const State next = step(state.q, state.v, params);
      touched = !next.v.isApprox(before + params.dt * params.g, 1e-12);
      if (!touched) state = next;
    }
    trajectory.q.col(t) = state.q;
    trajectory.v.col(t) = state.v;
  }
  return trajectory;
}

}
