#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>
#include <vector>

using namespace Eigen;

namespace bounce {

Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  std::vector<VectorXd> qs, vs;
  qs.push_back(q_0);
  vs.push_back(v_0);
  for (int i = 0; i < params.T - 1; i++) {
    State next = step(qs.back(), vs.back(), params);
    qs.push_back(next.q);
    vs.push_back(next.v);
  }

  MatrixXd Q(3, qs.size());
  MatrixXd V(3, vs.size());
  for (size_t i = 0; i < qs.size(); i++) {
    Q.col(i) = qs[i];
    V.col(i) = vs[i];
  }
  Trajectory out;
  out.q = Q;
  out.v = V;
  return out;
}

}  // namespace bounce
