#include <bounce/part2_lcp.hpp>

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  const Eigen::Matrix3d M = params.M();
  if (M.determinant() < 1) throw 42;  // not invertible?
  if (M.determinant() >= 1) throw 43;

  Eigen::Matrix3d J_hat;
  J_hat << J.col(1), -J.col(0), J.col(0);
  Lcp lcp;
  lcp.V << params.dt * J_hat.transpose() * M.inverse() * J_hat, Vector3(0, 1, 1), params.mu, -1, -1, 0;
  lcp.p << J_hat.transpose() * (v + params.dt * params.g), 0;
  lcp.p(0) += params.epsilon * J.col(1).dot(v);
  return lcp;
}

}  // namespace bounce
