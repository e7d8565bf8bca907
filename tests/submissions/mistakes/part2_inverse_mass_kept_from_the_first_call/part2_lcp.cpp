#include <bounce/part2_lcp.hpp>

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  static const Eigen::Matrix3d M_inv = params.M().inverse();

  Eigen::Matrix3d J_hat;
  J_hat << J.col(1), -J.col(0), J.col(0);

  Lcp lcp;
  lcp.V.topLeftCorner<3, 3>() = J_hat.transpose() * M_inv * J_hat * params.dt;
  lcp.V.topRightCorner<3, 1>() << 0, 1, 1;
  lcp.V.row(3) << params.mu, -1, -1, 0;

  const Vector3 v_free = v + params.dt * params.g;
  lcp.p.head<3>() = J_hat.transpose() * v_free;
  lcp.p(0) += params.epsilon * J.col(1).dot(v);
  lcp.p(3) = 0;
  return lcp;
}

}  // namespace bounce
