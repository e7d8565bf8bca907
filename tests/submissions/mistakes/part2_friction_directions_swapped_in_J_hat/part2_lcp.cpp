#include <bounce/part2_lcp.hpp>

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  const double dt = params.dt;
  const Vector3 J_t = J.col(0);
  const Vector3 J_n = J.col(1);
  Eigen::Matrix3d J_hat;
  J_hat << J_n, J_t, -J_t;

  const Eigen::Matrix3d M = params.M();
  const Eigen::Matrix3d M_inv = M.inverse();
  const Vector3 f_e = M * params.g;

  Lcp lcp;
  lcp.V << J_hat.transpose() * M_inv * J_hat * dt, Vector3(0, 1, 1),
      params.mu, -1, -1, 0;
  lcp.p << J_n.transpose() * ((1 + params.epsilon) * v + dt * M_inv * f_e),
      -J_t.transpose() * (v + dt * M_inv * f_e),
      J_t.transpose() * (v + dt * M_inv * f_e),
      0;
  return lcp;
}

}  // namespace bounce
