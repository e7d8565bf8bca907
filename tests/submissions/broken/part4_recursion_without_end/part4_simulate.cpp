#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>

namespace bounce {

Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  // all columns but the last, then one step more
  Parameters shorter = params;
  shorter.T = params.T - 1;
  Trajectory trajectory = simulate(q_0, v_0, shorter);

  const State next = step(trajectory.q.rightCols(1), trajectory.v.rightCols(1), params);
  trajectory.q.conservativeResize(3, params.T);
  trajectory.v.conservativeResize(3, params.T);
  trajectory.q.rightCols(1) = next.q;
  trajectory.v.rightCols(1) = next.v;
  return trajectory;
}

}  // namespace bounce
