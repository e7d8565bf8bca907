#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>
#include <cmath>

namespace bounce {

// -0.0000 looks odd in a table
static Vector3 tidy(Vector3 q) {
  for (int i = 0; i < 3; ++i) {
    if (std::fabs(q(i)) < 1e-3) q(i) = 0;
  }
  return q;
}

Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  Trajectory trajectory;
  trajectory.q.resize(3, params.T);
  trajectory.v.resize(3, params.T);
  State state{q_0, v_0};
  trajectory.q.col(0) = q_0;
  trajectory.v.col(0) = v_0;
  for (int t = 1; t < params.T; ++t) {
    state = step(state.q, state.v, params);
    trajectory.q.col(t) = tidy(state.q);
    trajectory.v.col(t) = state.v;
  }
  return trajectory;
}

}  // namespace bounce
