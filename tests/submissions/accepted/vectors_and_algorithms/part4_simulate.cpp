#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>

#include <algorithm>
#include <vector>

namespace bounce {

Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  std::vector<State> states;
  states.reserve(static_cast<std::size_t>(params.T));
  State next{q_0, v_0};
  std::generate_n(std::back_inserter(states), params.T, [&, first = true]() mutable {
    if (!first) next = step(next.q, next.v, params);
    first = false;
    return next;
  });

  Trajectory trajectory{Eigen::Matrix3Xd(3, params.T), Eigen::Matrix3Xd(3, params.T)};
  Eigen::Index t = 0;
  for (const State& state : states) {
    trajectory.q.col(t) = state.q;
    trajectory.v.col(t++) = state.v;
  }
  return trajectory;
}

}  // namespace bounce
