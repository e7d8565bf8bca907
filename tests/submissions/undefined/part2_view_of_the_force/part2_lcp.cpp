#include <bounce/part2_lcp.hpp>

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  const Eigen::Matrix3d M_inv = params.M().inverse();
  auto f_e = params.M() * params.g;
  const Vector3 moved = M_inv * f_e;

  Eigen::Matrix3d directions;
  directions << J.col(1), -J.col(0), J.col(0);
  Lcp lcp;
  lcp.V << params.dt * directions.transpose() * M_inv * directions, Eigen::Vector3d(0, 1, 1),
      params.mu, -1, -1, 0;
  lcp.p << directions.transpose() * (v + params.dt * moved), 0;
  lcp.p(0) += params.epsilon * J.col(1).dot(v);
  return lcp;
}

}  // namespace bounce
