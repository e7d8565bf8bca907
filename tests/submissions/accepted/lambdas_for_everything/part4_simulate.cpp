#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>

namespace bounce {

Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  Trajectory tr{Eigen::Matrix3Xd(3, params.T), Eigen::Matrix3Xd(3, params.T)};
  const auto put = [&tr](int t, const State& s) {
    tr.q.col(t) = s.q;
    tr.v.col(t) = s.v;
  };
  const auto get = [&tr](int t) { return State{tr.q.col(t), tr.v.col(t)}; };
  const auto advance = [&params](const State& s) { return step(s.q, s.v, params); };

  put(0, {q_0, v_0});
  for (int t = 1; t < params.T; ++t) put(t, advance(get(t - 1)));
  return tr;
}

}  // namespace bounce
