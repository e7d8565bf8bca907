#include <bounce/part2_lcp.hpp>

using namespace Eigen;

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  MatrixXd M = params.M();
  MatrixXd Minv = M.inverse();
  VectorXd fe = M * params.g;
  VectorXd Jt = J.col(0);
  VectorXd Jn = J.col(1);

  // Jhat = np.hstack([Jn, -Jt, Jt])
  MatrixXd Jhat(3, 3);
  Jhat.col(0) = Jn;
  Jhat.col(1) = -Jt;
  Jhat.col(2) = Jt;

  MatrixXd V = MatrixXd::Zero(4, 4);
  V.block(0, 0, 3, 3) = Jhat.transpose() * Minv * Jhat * params.dt;
  V(1, 3) = 1;
  V(2, 3) = 1;
  V(3, 0) = params.mu;
  V(3, 1) = -1;
  V(3, 2) = -1;

  VectorXd dv = params.dt * Minv * fe;
  VectorXd p = VectorXd::Zero(4);
  p(0) = Jn.dot((1 + params.epsilon) * v + dv);
  p(1) = -Jt.dot(v + dv);
  p(2) = Jt.dot(v + dv);

  Lcp lcp;
  lcp.V = V;
  lcp.p = p;
  return lcp;
}

}  // namespace bounce
