#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>
#include <list>

namespace bounce {

Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  std::list<State> states(1, State{q_0, v_0});
  while (static_cast<int>(states.size()) < params.T) {
    states.push_front(step(states.front().q, states.front().v, params));
  }

  Trajectory trajectory;
  trajectory.q.setZero(3, params.T);
  trajectory.v.setZero(3, params.T);
  int t = params.T;
  for (const State& state : states) {  // the newest comes first
    --t;
    trajectory.q.col(t) = state.q;
    trajectory.v.col(t) = state.v;
  }
  return trajectory;
}

}  // namespace bounce
