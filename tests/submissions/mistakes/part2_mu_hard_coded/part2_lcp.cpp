#include <bounce/part2_lcp.hpp>

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  const double mu = 0.3;
  const double h = params.dt;
  const Vector3 f_e = params.M() * params.g;
  const Eigen::Matrix3d M_inv = params.M().inverse();
  const Vector3 J_t = J.col(0), J_n = J.col(1);
  Eigen::Matrix3d J_hat;
  J_hat << J_n, -J_t, J_t;

  Eigen::Matrix4d V;
  V << h * J_hat.transpose() * M_inv * J_hat, Vector3(0, 1, 1), Eigen::RowVector4d(mu, -1, -1, 0);
  Eigen::Vector4d p;
  p << J_n.dot((1 + params.epsilon) * v + h * M_inv * f_e), -J_t.dot(v + h * M_inv * f_e),
      J_t.dot(v + h * M_inv * f_e), 0;
  return {V, p};
}

}  // namespace bounce
