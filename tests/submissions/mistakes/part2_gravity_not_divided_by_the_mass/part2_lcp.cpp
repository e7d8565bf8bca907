#include <bounce/part2_lcp.hpp>

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  const Vector3 J_t = J.col(0);
  const Vector3 J_n = J.col(1);
  Eigen::Matrix3d J_hat;
  J_hat << J_n, -J_t, J_t;

  const Vector3 f_e = params.M() * params.g;
  const Eigen::Matrix3d block = J_hat.transpose() * params.M().inverse() * J_hat * params.dt;

  Lcp lcp;
  lcp.V << block, Vector3(0, 1, 1), params.mu, -1, -1, 0;
  lcp.p << (1 + params.epsilon) * J_n.dot(v) + params.dt * J_n.dot(f_e),
      -J_t.dot(v) - params.dt * J_t.dot(f_e),
      J_t.dot(v) + params.dt * J_t.dot(f_e),
      0;
  return lcp;
}

}  // namespace bounce
