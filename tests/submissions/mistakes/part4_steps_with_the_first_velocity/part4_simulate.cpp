#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>

namespace bounce {

Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  Trajectory trajectory;
  trajectory.q.resize(Eigen::NoChange, params.T);
  trajectory.v.resize(Eigen::NoChange, params.T);

  trajectory.q.col(0) = q_0;
  trajectory.v.col(0) = v_0;
  Vector3 q = q_0;
  for (Eigen::Index t = 1; t < trajectory.q.cols(); ++t) {
    const State next = step(q, v_0, params);
    trajectory.q.col(t) = next.q;
    trajectory.v.col(t) = next.v;
    q = next.q;
  }
  return trajectory;
}

}  // namespace bounce
