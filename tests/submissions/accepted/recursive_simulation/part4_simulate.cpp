#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>

namespace bounce {

static void fill(Trajectory& trajectory, int t, const State& state, const Parameters& params) {
  trajectory.q.col(t) = state.q;
  trajectory.v.col(t) = state.v;
  if (t + 1 == params.T) return;
  fill(trajectory, t + 1, step(state.q, state.v, params), params);
}

Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  Trajectory trajectory;
  trajectory.q.resize(3, params.T);
  trajectory.v.resize(3, params.T);
  fill(trajectory, 0, {q_0, v_0}, params);
  return trajectory;
}

}  // namespace bounce
