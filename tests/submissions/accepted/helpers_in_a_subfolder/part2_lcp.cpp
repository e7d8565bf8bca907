#include <bounce/part2_lcp.hpp>

#include "helpers/inertia.hpp"

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  Eigen::Matrix3d J_hat;
  J_hat << J.col(1), -J.col(0), J.col(0);
  const Eigen::Matrix3d M_inv = helpers::inverse_inertia(params);
  const Vector3 dv = params.dt * M_inv * helpers::external_force(params);

  Lcp lcp;
  lcp.V << params.dt * J_hat.transpose() * M_inv * J_hat, Vector3(0, 1, 1), params.mu, -1, -1, 0;
  lcp.p << J_hat.transpose() * (v + dv), 0;
  lcp.p(0) += params.epsilon * J.col(1).dot(v);
  return lcp;
}

}  // namespace bounce
