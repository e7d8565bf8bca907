#include <bounce/part2_lcp.hpp>

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  const Vector3 J_t = J.col(0);
  const Vector3 J_n = J.col(1);
  const Eigen::Matrix3d M_inv = params.M().inverse();
  const Vector3 f_e = params.M() * params.g;
  const Vector3 w = (1 + params.epsilon) * v + params.dt * M_inv * f_e;

  Eigen::Matrix3d J_hat;
  J_hat.col(0) = J_n;
  J_hat.col(1) = -J_t;
  J_hat.col(2) = J_t;

  Lcp lcp;
  lcp.V.setZero();
  lcp.V.topLeftCorner<3, 3>() = J_hat.transpose() * M_inv * J_hat * params.dt;
  lcp.V.topRightCorner<3, 1>() = Vector3(0, 1, 1);
  lcp.V.row(3) << params.mu, -1, -1, 0;
  lcp.p.setZero();
  lcp.p.head<3>() = J_hat.transpose() * w;
  return lcp;
}

}  // namespace bounce
