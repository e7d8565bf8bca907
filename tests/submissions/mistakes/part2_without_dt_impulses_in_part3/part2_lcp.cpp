#include <bounce/part2_lcp.hpp>

namespace bounce {

// in terms of impulses (N s), part 3 uses them in the same way
Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  const Eigen::Matrix3d M_inv = params.M().inverse();
  const Vector3 J_t = J.col(0), J_n = J.col(1);
  Eigen::Matrix3d J_hat;
  J_hat << J_n, -J_t, J_t;

  const Vector3 f_e = params.M() * params.g;
  const Vector3 v_e = params.dt * M_inv * f_e;

  Lcp lcp;
  lcp.V << J_hat.transpose() * M_inv * J_hat, Vector3(0, 1, 1),
      Eigen::RowVector4d(params.mu, -1, -1, 0);
  lcp.p << J_n.dot((1 + params.epsilon) * v + v_e), -J_t.dot(v + v_e), J_t.dot(v + v_e), 0;
  return lcp;
}

}  // namespace bounce
