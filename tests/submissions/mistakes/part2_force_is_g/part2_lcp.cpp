#include <bounce/part2_lcp.hpp>

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  const Vector3 f_e = params.g;
  const Eigen::Matrix3d M_inv = params.M().inverse();
  const double dt = params.dt;
  const double eps = params.epsilon;

  const Vector3 J_t = J.col(0);
  const Vector3 J_n = J.col(1);
  Eigen::Matrix3d J_hat;
  J_hat << J_n, -J_t, J_t;

  Lcp lcp;
  lcp.V.topLeftCorner<3, 3>() = J_hat.transpose() * M_inv * J_hat * dt;
  lcp.V.topRightCorner<3, 1>() = Vector3(0, 1, 1);
  lcp.V.bottomLeftCorner<1, 3>() = Eigen::RowVector3d(params.mu, -1, -1);
  lcp.V(3, 3) = 0;

  lcp.p(0) = J_n.dot((1 + eps) * v + dt * M_inv * f_e);
  lcp.p(1) = -J_t.dot(v + dt * M_inv * f_e);
  lcp.p(2) = -lcp.p(1);
  lcp.p(3) = 0;
  return lcp;
}

}  // namespace bounce
