#include <bounce/part2_lcp.hpp>

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  const Vector3 J_t = J.col(0);
  const Vector3 J_n = J.col(1);
  const Eigen::Matrix3d M_inv = params.M().inverse();
  const Vector3 f_e = params.M() * params.g;

  Eigen::Matrix3d J_hat;
  J_hat << J_n, -J_t, J_t;

  Eigen::Matrix4d V = Eigen::Matrix4d::Zero();
  V.topLeftCorner<3, 3>() = J_hat.transpose() * M_inv * J_hat * params.dt;
  V.col(3) << 0, 1, 1, 0;
  V.row(3) << params.mu, -1, -1, 0;

  const Vector3 dv = params.dt * M_inv * f_e;
  Eigen::Vector4d p;
  p(0) = J_n.dot((1 + params.epsilon) * v + dv);
  p(1) = -J_t.dot(v + dv);
  p(2) = J_t.dot(v + dv);
  p(3) = 0;
  return {V, p};
}

}  // namespace bounce
