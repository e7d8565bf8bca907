#include <bounce/part2_lcp.hpp>

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  const Vector3 J_t = J.col(0), J_n = J.col(1);
  Eigen::Matrix3d J_hat;
  J_hat << J_n, -J_t, J_t;
  const Eigen::Matrix3d M = params.M();
  const Vector3 f_e = M * params.g;
  const Vector3 e = Vector3::Ones();

  Lcp lcp;
  lcp.V << J_hat.transpose() * M.inverse() * J_hat * params.dt, e,
      params.mu, -1, -1, 0;
  const Vector3 dv = params.dt * M.inverse() * f_e;
  lcp.p << J_n.dot((1 + params.epsilon) * v + dv), -J_t.dot(v + dv), J_t.dot(v + dv), 0;
  return lcp;
}

}  // namespace bounce
