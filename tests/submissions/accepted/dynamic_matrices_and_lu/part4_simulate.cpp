#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>

namespace bounce {

Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  Eigen::MatrixXd q(3, 1), v(3, 1);
  q << q_0;
  v << v_0;
  while (q.cols() < params.T) {
    const State next = step(q.rightCols(1), v.rightCols(1), params);
    q.conservativeResize(3, q.cols() + 1);
    v.conservativeResize(3, v.cols() + 1);
    q.rightCols(1) = next.q;
    v.rightCols(1) = next.v;
  }
  return {q, v};
}

}  // namespace bounce
