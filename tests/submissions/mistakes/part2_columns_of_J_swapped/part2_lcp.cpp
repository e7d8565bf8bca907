#include <bounce/part2_lcp.hpp>

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  const Vector3 J_n = J.col(0);
  const Vector3 J_t = J.col(1);
  const Eigen::Matrix3d M = params.M();
  const Eigen::Matrix3d M_inv = M.inverse();
  const Vector3 f_e = M * params.g;

  Eigen::Matrix3d J_hat;
  J_hat.col(0) = J_n;
  J_hat.col(1) = -J_t;
  J_hat.col(2) = J_t;

  Lcp lcp;
  lcp.V.setZero();
  lcp.V.topLeftCorner<3, 3>() = J_hat.transpose() * M_inv * J_hat * params.dt;
  lcp.V.col(3).head<3>() << 0, 1, 1;
  lcp.V.row(3).head<3>() << params.mu, -1, -1;

  const Vector3 w = v + params.dt * M_inv * f_e;
  lcp.p << J_n.dot(w + params.epsilon * v), -J_t.dot(w), J_t.dot(w), 0;
  return lcp;
}

}  // namespace bounce
