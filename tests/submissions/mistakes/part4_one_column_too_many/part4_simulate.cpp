#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>

namespace bounce {

Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  Trajectory traj;
  traj.q.resize(3, params.T + 1);
  traj.v.resize(3, params.T + 1);
  traj.q.col(0) = q_0;
  traj.v.col(0) = v_0;
  for (int t = 0; t < params.T; t++) {
    const State next = step(traj.q.col(t), traj.v.col(t), params);
    traj.q.col(t + 1) = next.q;
    traj.v.col(t + 1) = next.v;
  }
  return traj;
}

}  // namespace bounce
