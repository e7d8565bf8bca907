#include <bounce/part2_lcp.hpp>

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  const Eigen::Matrix3d M_inv = params.M().inverse();
  const Vector3 f_e = params.M() * params.g;
  Eigen::Matrix3d J_hat;
  J_hat << J.col(1), -J.col(0), J.col(0);

  Lcp lcp;
  lcp.V << J_hat.transpose() * M_inv * J_hat * params.dt, Vector3(0, 1, 1), params.mu, -1, -1, 0;
  lcp.p << J.col(1).dot((1 + params.epsilon) * v + params.dt * M_inv * f_e),
      -J.col(0).dot(v + params.dt * M_inv * f_e), J.col(0).dot(v + params.dt * M_inv * f_e), 0;
  return lcp;
}

}  // namespace bounce
