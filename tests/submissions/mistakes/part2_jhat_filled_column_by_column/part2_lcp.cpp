#include <bounce/part2_lcp.hpp>

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  const double rows[] = {J(0, 1), -J(0, 0), J(0, 0),   //
                         J(1, 1), -J(1, 0), J(1, 0),   //
                         J(2, 1), -J(2, 0), J(2, 0)};
  const Eigen::Matrix3d J_hat = Eigen::Map<const Eigen::Matrix3d>(rows);
  const Eigen::Matrix3d M_inv = params.M().inverse();

  Lcp lcp;
  lcp.V.topLeftCorner<3, 3>() = J_hat.transpose() * M_inv * J_hat * params.dt;
  lcp.V.topRightCorner<3, 1>() << 0, 1, 1;
  lcp.V.row(3) << params.mu, -1, -1, 0;

  lcp.p.head<3>() = J_hat.transpose() * (v + params.dt * params.g);
  lcp.p(0) += params.epsilon * J_hat.col(0).dot(v);
  lcp.p(3) = 0;
  return lcp;
}

}  // namespace bounce
