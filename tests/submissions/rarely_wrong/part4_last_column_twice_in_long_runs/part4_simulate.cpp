#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>

namespace bounce {

namespace {

// So that an animation of a long run stands for a moment before it begins again.
constexpr int kLong = 50;

}  // namespace

Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  const int last = params.T - 1;
  Trajectory trajectory{Eigen::Matrix3Xd(3, params.T), Eigen::Matrix3Xd(3, params.T)};
  State state{q_0, v_0};
  for (int t = 0; t <= last; ++t) {
    trajectory.q.col(t) = state.q;
    trajectory.v.col(t) = state.v;
    state = step(state.q, state.v, params);
  }
  if (params.T > kLong) {
    trajectory.q.col(last) = trajectory.q.col(last - 1);
    trajectory.v.col(last) = trajectory.v.col(last - 1);
  }
  return trajectory;
}

}  // namespace bounce
