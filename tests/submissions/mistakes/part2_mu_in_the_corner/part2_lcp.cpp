#include <bounce/part2_lcp.hpp>

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  const Vector3 J_t = J.col(0), J_n = J.col(1);
  const Eigen::Matrix3d M_inv = params.M().inverse();
  Eigen::Matrix3d J_hat;
  J_hat << J_n, -J_t, J_t;
  const Eigen::Matrix3d A = J_hat.transpose() * M_inv * J_hat * params.dt;

  Eigen::Matrix4d V;
  V << A(0, 0), A(0, 1), A(0, 2), 0,
       A(1, 0), A(1, 1), A(1, 2), 1,
       A(2, 0), A(2, 1), A(2, 2), 1,
       0, -1, -1, params.mu;

  const Vector3 f_e = params.M() * params.g;
  Eigen::Vector4d p;
  p(0) = J_n.dot((1 + params.epsilon) * v + params.dt * M_inv * f_e);
  p(1) = -J_t.dot(v + params.dt * M_inv * f_e);
  p(2) = J_t.dot(v + params.dt * M_inv * f_e);
  p(3) = 0;
  return {V, p};
}

}  // namespace bounce
