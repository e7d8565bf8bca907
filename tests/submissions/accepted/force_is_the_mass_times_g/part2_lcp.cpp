#include <bounce/part2_lcp.hpp>

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  const Vector3 f_e = params.m * params.g;
  const Eigen::DiagonalMatrix<double, 3> M_inv(1 / params.m, 1 / params.m, 6 / (params.m * params.l * params.l));
  const Vector3 J_t = J.col(0);
  const Vector3 J_n = J.col(1);
  Eigen::Matrix3d J_hat;
  J_hat << J_n, -J_t, J_t;

  Lcp lcp;
  lcp.V.setZero();
  lcp.V.topLeftCorner<3, 3>() = params.dt * J_hat.transpose() * M_inv * J_hat;
  lcp.V.topRightCorner<3, 1>() << 0, 1, 1;
  lcp.V.bottomLeftCorner<1, 3>() << params.mu, -1, -1;

  const Vector3 dv = params.dt * (M_inv * f_e);
  lcp.p << J_n.dot((1 + params.epsilon) * v + dv), -J_t.dot(v + dv), J_t.dot(v + dv), 0;
  return lcp;
}

}  // namespace bounce
