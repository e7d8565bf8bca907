#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>

namespace bounce {

namespace {

template <typename Function>
void repeat(int times, Function function) {
  for (int k = 0; k < times; ++k) function(k);
}

}  // namespace

Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  Trajectory tr;
  tr.q.resize(Eigen::NoChange, params.T);
  tr.v.resize(Eigen::NoChange, params.T);
  tr.q.col(0) = q_0;
  tr.v.col(0) = v_0;
  repeat(params.T - 1, [&](int t) {
    const State s = step(tr.q.col(t), tr.v.col(t), params);
    tr.q.col(t + 1) = s.q;
    tr.v.col(t + 1) = s.v;
  });
  return tr;
}

}  // namespace bounce
