#include <bounce/part2_lcp.hpp>

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  const Vector3 J_t = J.col(0);
  const Vector3 J_n = J.col(1);
  Eigen::Matrix3d J_hat;
  J_hat.col(0) = J_n;
  J_hat.col(1) = -J_t;
  J_hat.col(2) = J_t;

  const Eigen::Matrix3d M = params.M();
  const Vector3 f_e = M * params.g;
  const Vector3 a = M.inverse() * f_e;

  Lcp lcp;
  lcp.V.setZero();
  lcp.V.topLeftCorner<3, 3>() = J_hat.transpose() * M.inverse() * J_hat * params.dt;
  lcp.V(1, 3) = lcp.V(2, 3) = 1;
  lcp.V.row(3) << params.mu, -1, -1, 0;
  lcp.p(0) = J_n.dot((1 + params.epsilon) * v + a);
  lcp.p(1) = -J_t.dot(v + a);
  lcp.p(2) = J_t.dot(v + a);
  lcp.p(3) = 0;
  return lcp;
}

}  // namespace bounce
