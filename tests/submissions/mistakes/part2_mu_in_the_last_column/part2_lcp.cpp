#include <bounce/part2_lcp.hpp>

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  const auto t = J.col(0);
  const auto n = J.col(1);
  Eigen::Matrix3d J_hat;
  J_hat << n, -t, t;
  const Eigen::Matrix3d W = params.M().inverse();

  Lcp lcp;
  lcp.V.topLeftCorner(3, 3) = params.dt * J_hat.transpose() * W * J_hat;
  lcp.V.rightCols<1>() = Eigen::Vector4d(params.mu, 1, 1, 0);
  lcp.V.bottomLeftCorner<1, 3>() = Eigen::RowVector3d(0, -1, -1);

  const Vector3 f_e = params.M() * params.g;
  const Vector3 u = v + params.dt * W * f_e;
  lcp.p << n.dot(u) + params.epsilon * n.dot(v), -t.dot(u), t.dot(u), 0;
  return lcp;
}

}  // namespace bounce
