#include <bounce/part2_lcp.hpp>

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  const Vector3 J_t = J.col(0), J_n = J.col(1);
  Eigen::Matrix3d J_hat;
  J_hat << J_n, -J_t, J_t;
  const Eigen::Matrix3d M_inv = params.M().inverse();
  const Vector3 v_e = v + params.dt * params.g;

  Lcp lcp;
  lcp.V.setZero();
  lcp.V.block<3, 3>(0, 0) = params.dt * J_hat.transpose() * M_inv * J_hat;
  lcp.V.col(3) << 0, 1, 1, 0;
  lcp.V.row(3) << -params.mu, 1, 1, 0;
  lcp.p << J_n.dot(v_e) + params.epsilon * J_n.dot(v), -J_t.dot(v_e), J_t.dot(v_e), 0;
  return lcp;
}

}  // namespace bounce
