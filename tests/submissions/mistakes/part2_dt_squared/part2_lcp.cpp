#include <bounce/part2_lcp.hpp>

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  const double dt = params.dt;
  const Eigen::Matrix3d M_inv = params.M().inverse();
  const Vector3 f_e = params.M() * params.g;

  Eigen::Matrix3d J_hat;
  J_hat << J.col(1), -J.col(0), J.col(0);
  const Eigen::Matrix3d J_dt = J_hat * dt;

  Lcp lcp;
  lcp.V.topLeftCorner<3, 3>() = J_dt.transpose() * M_inv * J_dt;
  lcp.V.topRightCorner<3, 1>() << 0, 1, 1;
  lcp.V.row(3) << params.mu, -1, -1, 0;

  const Vector3 v_free = v + dt * M_inv * f_e;
  lcp.p.head<3>() = J_hat.transpose() * v_free;
  lcp.p(0) += params.epsilon * v.dot(J.col(1));
  lcp.p(3) = 0;
  return lcp;
}

}  // namespace bounce
