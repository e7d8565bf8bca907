#include <bounce/part2_lcp.hpp>

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  const Vector3 J_t = J.col(0);
  const Vector3 J_n = J.col(1);
  const Eigen::Matrix3d W = params.M().inverse();

  Eigen::Matrix<double, 3, 3> J_hat;
  J_hat << J_n, -J_t, J_t;

  Eigen::Matrix4d V = Eigen::Matrix4d::Zero();
  V.topLeftCorner<3, 3>() = params.dt * J_hat.transpose() * W * J_hat;
  V(3, 0) = params.mu;
  V(3, 1) = -1;
  V(3, 2) = -1;

  const Vector3 f_e = params.M() * params.g;
  const Vector3 dv = params.dt * W * f_e;
  Eigen::Vector4d p = Eigen::Vector4d::Zero();
  p(0) = J_n.dot((1 + params.epsilon) * v + dv);
  p(1) = -J_t.dot(v + dv);
  p(2) = J_t.dot(v + dv);

  return Lcp{V, p};
}

}  // namespace bounce
