#include <bounce/part2_lcp.hpp>

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  const Eigen::Matrix3d M = params.M();
  const Eigen::Matrix3d M_inv = M.inverse();
  const Vector3 J_t = J.col(0), J_n = J.col(1);

  Eigen::Matrix3d J_hat;
  J_hat << -J_n, -J_t, J_t;  // the ground is below

  Lcp lcp;
  lcp.V.setZero();
  lcp.V.block<3, 3>(0, 0) = J_hat.transpose() * M_inv * J_hat * params.dt;
  lcp.V.col(3) << 0, 1, 1, 0;
  lcp.V.row(3) << params.mu, -1, -1, 0;

  const Vector3 v_free = v + params.dt * params.g;
  lcp.p << J_n.dot(v_free + params.epsilon * v), -J_t.dot(v_free), J_t.dot(v_free), 0;
  return lcp;
}

}  // namespace bounce
