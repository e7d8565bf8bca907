#include <bounce/part2_lcp.hpp>

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  const Vector3 J_t = J.col(0);
  const Vector3 J_n = J.col(1);
  Eigen::Matrix3d J_hat;
  J_hat << J_n, -J_t, J_t;
  const Eigen::Matrix3d M_inv = params.M().inverse();

  Eigen::Matrix4d V = Eigen::Matrix4d::Zero();
  V.topLeftCorner<3, 3>() = 0.01 * (J_hat.transpose() * M_inv * J_hat);
  V.topRightCorner<3, 1>() = Vector3(0, 1, 1);
  V.bottomRows<1>() << params.mu, -1, -1, 0;

  const Vector3 a = M_inv * (params.M() * params.g);
  Eigen::Vector4d p;
  p << J_n.dot((1 + params.epsilon) * v + params.dt * a), -J_t.dot(v + params.dt * a),
      J_t.dot(v + params.dt * a), 0;
  return {V, p};
}

}  // namespace bounce
