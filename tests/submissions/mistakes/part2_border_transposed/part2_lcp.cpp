#include <bounce/part2_lcp.hpp>

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  const Eigen::Matrix3d M_inv = params.M().inverse();
  const Vector3 f_e = params.M() * params.g;
  Eigen::Matrix3d J_hat;
  J_hat << J.col(1), -J.col(0), J.col(0);

  Eigen::Matrix4d V = Eigen::Matrix4d::Zero();
  V.topLeftCorner<3, 3>() = J_hat.transpose() * M_inv * J_hat * params.dt;
  V.col(3) << params.mu, -1, -1, 0;
  V.row(3) << 0, 1, 1, 0;

  Eigen::Vector4d p;
  p << J_hat.transpose() * (v + params.dt * M_inv * f_e), 0;
  p(0) += params.epsilon * J.col(1).dot(v);
  return {V, p};
}

}  // namespace bounce
