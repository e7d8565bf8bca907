#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>

namespace bounce {

Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  const int T = params.T;
  Trajectory tr;
  tr.q = Eigen::Matrix3Xd::Zero(3, T);
  tr.v = Eigen::Matrix3Xd::Zero(3, T);
  tr.q.col(0) = q_0;
  tr.v.col(0) = v_0;
  int t = 1;
  while (t < T) {
    const State s = step(tr.q.col(t - 1), tr.v.col(t - 1), params);
    tr.q.col(t) = s.q;
    tr.v.col(t) = s.v;
    ++t;
  }
  return tr;
}

}  // namespace bounce
