#include <bounce/part2_lcp.hpp>
#include <cmath>

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  const double r_g = params.l / std::sqrt(6.0);
  Eigen::Matrix3d M = Eigen::Matrix3d::Zero();
  M(0, 0) = params.m;
  M(1, 1) = params.m;
  M(2, 2) = params.m * r_g;
  const Eigen::Matrix3d M_inv = M.inverse();
  const Vector3 f_e = M * params.g;

  const Vector3 J_t = J.col(0), J_n = J.col(1);
  Eigen::Matrix3d J_hat;
  J_hat << J_n, -J_t, J_t;

  Lcp lcp;
  lcp.V.topLeftCorner<3, 3>() = J_hat.transpose() * M_inv * J_hat * params.dt;
  lcp.V.topRightCorner<3, 1>() << 0, 1, 1;
  lcp.V.row(3) << params.mu, -1, -1, 0;
  const Vector3 v_f = v + params.dt * M_inv * f_e;
  lcp.p << J_n.dot(v_f + params.epsilon * v), -J_t.dot(v_f), J_t.dot(v_f), 0;
  return lcp;
}

}  // namespace bounce
