#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>
#include <algorithm>
#include <cmath>

namespace bounce {

Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  Trajectory trajectory{Eigen::Matrix3Xd(3, params.T), Eigen::Matrix3Xd(3, params.T)};
  State state{q_0, v_0};
  for (int t = 0; t < params.T; ++t) {
    if (t > 0) state = step(state.q, state.v, params);
    state.q(2) = std::remainder(state.q(2), 2 * 3.14159265358979323846);
    trajectory.q.col(t) = state.q;
    trajectory.v.col(t) = state.v;
  }
  return trajectory;
}

}
