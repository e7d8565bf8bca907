#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>

namespace bounce {

Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  Trajectory tr{q_0, v_0};
  while (tr.q.cols() < params.T) {
    const Eigen::Index n = tr.q.cols();
    const State s = step(tr.q.col(n - 1), tr.v.col(n - 1), params);
    tr.q.conservativeResize(Eigen::NoChange, n + 1);
    tr.v.conservativeResize(Eigen::NoChange, n + 1);
    tr.q.col(n) = s.q;
    tr.v.col(n) = s.v;
  }
  return tr;
}

}  // namespace bounce
