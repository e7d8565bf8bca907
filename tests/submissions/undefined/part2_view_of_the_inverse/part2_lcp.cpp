#include <bounce/part2_lcp.hpp>

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  Eigen::Matrix3d J_hat;
  J_hat << J.col(1), -J.col(0), J.col(0);

  const auto M_inv = params.M().inverse();
  const Vector3 v_free = v + params.dt * params.g;

  Lcp lcp;
  lcp.V.setZero();
  lcp.V.topLeftCorner<3, 3>() = params.dt * J_hat.transpose() * M_inv * J_hat;
  lcp.V(1, 3) = lcp.V(2, 3) = 1;
  lcp.V.row(3) << params.mu, -1, -1, 0;
  lcp.p << J.col(1).dot(v_free + params.epsilon * v), -J.col(0).dot(v_free), J.col(0).dot(v_free), 0;
  return lcp;
}

}  // namespace bounce
