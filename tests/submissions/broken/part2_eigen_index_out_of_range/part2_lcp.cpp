#include <bounce/part2_lcp.hpp>

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  Eigen::Matrix3d J_hat;
  J_hat << J.col(1), -J.col(0), J.col(0);
  const Eigen::Matrix3d M_inv = params.M().inverse();

  Lcp lcp;
  lcp.V.setZero();
  lcp.V.topLeftCorner<3, 3>() = params.dt * J_hat.transpose() * M_inv * J_hat;
  // e and mu, counted from 1
  for (int i = 2; i <= 3; ++i) lcp.V(i, 4) = 1;
  lcp.V(4, 1) = params.mu;
  for (int i = 2; i <= 3; ++i) lcp.V(4, i) = -1;

  const Vector3 w = v + params.dt * params.g;
  lcp.p << J.col(1).dot(w + params.epsilon * v), -J.col(0).dot(w), J.col(0).dot(w), 0;
  return lcp;
}

}  // namespace bounce
