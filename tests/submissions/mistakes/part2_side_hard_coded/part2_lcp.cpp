#include <bounce/part2_lcp.hpp>

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  const double m = params.m, l = 0.2;
  const Vector3 M(m, m, m * l * l / 6);
  const Vector3 M_inv = M.cwiseInverse();
  const Vector3 J_t = J.col(0), J_n = J.col(1);
  Eigen::Matrix3d J_hat;
  J_hat << J_n, -J_t, J_t;

  Lcp lcp;
  lcp.V.topLeftCorner<3, 3>() = J_hat.transpose() * M_inv.asDiagonal() * J_hat * params.dt;
  lcp.V.topRightCorner<3, 1>() << 0, 1, 1;
  lcp.V.row(3) << params.mu, -1, -1, 0;
  const Vector3 w = v + params.dt * params.g;
  lcp.p << J_n.dot(w + params.epsilon * v), -J_t.dot(w), J_t.dot(w), 0;
  return lcp;
}

}  // namespace bounce
