#include <bounce/part2_lcp.hpp>

namespace bounce {

static const double h = 0.01;

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  Eigen::Matrix3d J_hat;
  J_hat << J.col(1), -J.col(0), J.col(0);
  const Eigen::Matrix3d M_inv = params.M().inverse();
  const Vector3 u = v + h * M_inv * params.M() * params.g;

  Lcp lcp;
  lcp.V << h * J_hat.transpose() * M_inv * J_hat, Vector3(0, 1, 1),
      Eigen::RowVector4d(params.mu, -1, -1, 0);
  lcp.p << J.col(1).dot(u + params.epsilon * v), -J.col(0).dot(u), J.col(0).dot(u), 0;
  return lcp;
}

}  // namespace bounce
