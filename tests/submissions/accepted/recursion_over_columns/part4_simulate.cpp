#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>

namespace bounce {

namespace {

void fill(Trajectory& tr, int t, const State& now, const Parameters& params) {
  tr.q.col(t) = now.q;
  tr.v.col(t) = now.v;
  if (t + 1 < params.T) fill(tr, t + 1, step(now.q, now.v, params), params);
}

}  // namespace

Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  Trajectory tr;
  tr.q.resize(3, params.T);
  tr.v.resize(3, params.T);
  fill(tr, 0, {q_0, v_0}, params);
  return tr;
}

}  // namespace bounce
