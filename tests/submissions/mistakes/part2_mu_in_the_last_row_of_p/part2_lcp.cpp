#include <bounce/part2_lcp.hpp>

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  const auto J_t = J.col(0);
  const auto J_n = J.col(1);
  Eigen::Matrix3d J_hat;
  J_hat << J_n, -J_t, J_t;

  const Vector3 minv(1 / params.m, 1 / params.m, 6 / (params.m * params.l * params.l));
  const Vector3 f_e = params.M() * params.g;
  const Vector3 a = minv.cwiseProduct(f_e);

  Lcp lcp;
  lcp.V.topLeftCorner<3, 3>() = J_hat.transpose() * minv.asDiagonal() * J_hat * params.dt;
  lcp.V.col(3) << 0, 1, 1, 0;
  lcp.V.row(3) << params.mu, -1, -1, 0;
  lcp.p(0) = J_n.dot((1 + params.epsilon) * v + params.dt * a);
  lcp.p(1) = -J_t.dot(v + params.dt * a);
  lcp.p(2) = J_t.dot(v + params.dt * a);
  lcp.p(3) = params.mu;
  return lcp;
}

}  // namespace bounce
