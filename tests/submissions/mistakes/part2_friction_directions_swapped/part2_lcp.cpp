#include <bounce/part2_lcp.hpp>

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  const Vector3 tangent = J.col(0);
  const Vector3 normal = J.col(1);

  Eigen::Matrix3d J_hat;
  J_hat << normal, tangent, -tangent;

  const Eigen::Matrix3d M_inv = params.M().inverse();
  const Vector3 v_free = v + params.dt * params.g;

  Eigen::Matrix4d V = Eigen::Matrix4d::Zero();
  V.topLeftCorner<3, 3>() = J_hat.transpose() * M_inv * J_hat * params.dt;
  V.topRightCorner<3, 1>() << 0, 1, 1;
  V.bottomLeftCorner<1, 3>() << params.mu, -1, -1;

  Eigen::Vector4d p = Eigen::Vector4d::Zero();
  p.head<3>() = J_hat.transpose() * v_free;
  p(0) += params.epsilon * normal.dot(v);
  return {V, p};
}

}  // namespace bounce
