#include <bounce/part2_lcp.hpp>

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  const Vector3 J_t = J.col(0), J_n = J.col(1);
  Eigen::Matrix3d J_hat;
  J_hat << J_n, -J_t, J_t;
  Vector3 v_free = v;
  for (int i = 0; i < 3; ++i) {
    if (params.g(i) > 1e-3 || params.g(i) < -1e-3) v_free(i) += params.dt * params.g(i);
  }

  Lcp lcp;
  lcp.V.setZero();
  lcp.V.topLeftCorner<3, 3>() = params.dt * J_hat.transpose() * params.M().inverse() * J_hat;
  lcp.V.col(3) << 0, 1, 1, 0;
  lcp.V.row(3) << params.mu, -1, -1, 0;
  lcp.p << J_hat.transpose() * v_free, 0;
  lcp.p(0) += params.epsilon * J_n.dot(v);
  return lcp;
}

}  // namespace bounce
