#include <bounce/part2_lcp.hpp>

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  const Vector3 J_t = J.col(0);
  const Vector3 J_n = J.col(1);
  const Vector3 f_e = params.m * params.g;

  Eigen::Matrix3d J_hat;
  J_hat << J_n, -J_t, J_t;

  Lcp lcp;
  lcp.V.setZero();
  lcp.V.topLeftCorner<3, 3>() = J_hat.transpose() * J_hat * params.dt / params.m;
  lcp.V(1, 3) = lcp.V(2, 3) = 1;
  lcp.V(3, 0) = params.mu;
  lcp.V(3, 1) = lcp.V(3, 2) = -1;

  const Vector3 v_free = v + params.dt * f_e / params.m;
  lcp.p(0) = J_n.dot(v_free + params.epsilon * v);
  lcp.p(1) = -J_t.dot(v_free);
  lcp.p(2) = J_t.dot(v_free);
  lcp.p(3) = 0;
  return lcp;
}

}  // namespace bounce
