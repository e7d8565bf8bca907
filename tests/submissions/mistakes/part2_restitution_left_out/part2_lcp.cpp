#include <bounce/part2_lcp.hpp>

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  Eigen::Matrix3d J_hat;
  J_hat << J.col(1), -J.col(0), J.col(0);

  const Eigen::Matrix3d M_inv = params.M().inverse();
  const Vector3 f_e = params.M() * params.g;

  Eigen::Matrix4d V;
  V.setZero();
  V.block<3, 3>(0, 0) = J_hat.transpose() * M_inv * J_hat * params.dt;
  V(1, 3) = 1;
  V(2, 3) = 1;
  V.row(3) << params.mu, -1, -1, 0;

  Eigen::Vector4d p = Eigen::Vector4d::Zero();
  p.head<3>() = J_hat.transpose() * (v + params.dt * M_inv * f_e);
  return {V, p};
}

}  // namespace bounce
