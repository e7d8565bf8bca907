#include <bounce/part2_lcp.hpp>

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  const Vector3 J_t = J.col(0);
  const Vector3 J_n = J.col(1);
  Eigen::Matrix3d J_hat;
  J_hat << J_n, -J_t, J_t;

  const Eigen::Matrix3d M = params.M();
  const Eigen::Matrix3d M_inv = M.inverse();
  const Vector3 f_e = M * Vector3(params.g(0), params.g(1), 0);
  const Vector3 e(0, 1, 1);

  Lcp lcp;
  lcp.V.topLeftCorner<3, 3>() = J_hat.transpose() * M_inv * J_hat * params.dt;
  lcp.V.topRightCorner<3, 1>() = e;
  lcp.V.row(3) << params.mu, -1, -1, 0;


  const Vector3 v_free = v + params.dt * M_inv * f_e;
  lcp.p << J_n.dot(v_free + params.epsilon * v), -J_t.dot(v_free), J_t.dot(v_free), 0;
  return lcp;
}

}
