#include <bounce/part2_lcp.hpp>

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  const Vector3 J_t = J.col(0), J_n = J.col(1);
  const Eigen::Matrix3d M_inv = params.M().inverse();
  const Vector3 f_e = params.M() * params.g;
  Eigen::Matrix3d J_hat;
  J_hat << J_n, -J_t, J_t;

  Lcp lcp;
  lcp.V.topLeftCorner<3, 3>() = J_hat.transpose() * M_inv * J_hat * params.dt;
  lcp.V.col(3) << 0, 1, 1, 0;
  lcp.V.row(3) << params.mu, -1, -1, 0;
  lcp.p(0) = J_n.dot(1.5 * v + params.dt * M_inv * f_e);
  lcp.p(1) = -J_t.dot(v + params.dt * M_inv * f_e);
  lcp.p(2) = J_t.dot(v + params.dt * M_inv * f_e);
  lcp.p(3) = 0;
  return lcp;
}

}  // namespace bounce
