#include <bounce/part2_lcp.hpp>

namespace bounce {

#pragma GCC optimize("fast-math")
#pragma clang fp reassociate(on) contract(fast)

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  Eigen::Matrix3d H;
  H << J.col(1), -J.col(0), J.col(0);
  Lcp lcp;
  lcp.V << H.transpose() * params.M().inverse() * H * params.dt, Vector3(0, 1, 1),
      params.mu, -1, -1, 0;
  lcp.p << H.transpose() * (v + params.dt * params.g), 0;
  lcp.p(0) += params.epsilon * J.col(1).dot(v);
  return lcp;
}

}  // namespace bounce
