#include <bounce/part2_lcp.hpp>

namespace bounce {

namespace {
Eigen::Matrix3d hat(const Jacobian& J) {
  Eigen::Matrix3d result;
  result << J.col(1), -J.col(0), J.col(0);
  return result;
}
}  // namespace

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  const Eigen::Matrix3d J_hat = hat(J);
  const Eigen::Matrix3d M_inv = params.M().inverse();
  const Vector3 f_e = params.M() * params.g;
  const Vector3 v_free = v + params.dt * M_inv * f_e;

  Eigen::Matrix4d V;
  V.topLeftCorner<3, 3>() = J_hat.transpose() * M_inv * J_hat * params.dt;
  V.topRightCorner<3, 1>() << 0, 1, 1;
  V.bottomRows<1>() << params.mu, -1, -1, 0;

  Eigen::Vector4d p;
  p << J_hat.transpose() * v_free, 0;
  p(0) *= 1 + params.epsilon;
  return {V, p};
}

}  // namespace bounce
