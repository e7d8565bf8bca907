#include <bounce/part2_lcp.hpp>

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  const double I = 1.0 / 12.0 * params.m * params.l * params.l;
  const Vector3 inv_mass(1 / params.m, 1 / params.m, 1 / I);

  const Vector3 J_t = J.col(0);
  const Vector3 J_n = J.col(1);
  Eigen::Matrix3d J_hat;
  J_hat << J_n, -J_t, J_t;

  const Vector3 v_e = v + params.dt * params.g;  // M^-1 f_e = g

  Lcp lcp;
  lcp.V.setZero();
  lcp.V.topLeftCorner<3, 3>() = params.dt * J_hat.transpose() * inv_mass.asDiagonal() * J_hat;
  lcp.V(1, 3) = 1;
  lcp.V(2, 3) = 1;
  lcp.V.row(3).head<3>() << params.mu, -1, -1;
  lcp.p << J_n.dot(v_e) + params.epsilon * J_n.dot(v), -J_t.dot(v_e), J_t.dot(v_e), 0;
  return lcp;
}

}  // namespace bounce
