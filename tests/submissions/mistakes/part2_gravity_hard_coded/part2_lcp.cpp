#include <bounce/part2_lcp.hpp>

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  constexpr double g = 9.81;
  const Eigen::Matrix3d M = params.M();
  const Eigen::Matrix3d M_inv = M.inverse();
  const Vector3 f_e(0, -params.m * g, 0);
  const Vector3 free = v + params.dt * M_inv * f_e;

  const Vector3 J_t = J.col(0);
  const Vector3 J_n = J.col(1);
  Eigen::Matrix3d J_hat;
  J_hat << J_n, -J_t, J_t;

  Lcp lcp;
  lcp.V.topLeftCorner<3, 3>() = J_hat.transpose() * M_inv * J_hat * params.dt;
  lcp.V.col(3) = Eigen::Vector4d(0, 1, 1, 0);
  lcp.V.row(3) = Eigen::RowVector4d(params.mu, -1, -1, 0);
  lcp.p = Eigen::Vector4d(J_n.dot(free) + params.epsilon * J_n.dot(v), -J_t.dot(free), J_t.dot(free), 0);
  return lcp;
}

}  // namespace bounce
