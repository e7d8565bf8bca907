#include <bounce/part2_lcp.hpp>

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  const Vector3 J_t = J.col(0), J_n = J.col(1);
  const Eigen::Matrix3d M = params.M();
  const Eigen::Matrix3d M_inv = M.inverse();
  const Vector3 f_e = M * params.g;

  Eigen::Matrix3d J_hat;
  J_hat << J_n.transpose(),
           -J_t.transpose(),
           J_t.transpose();

  Eigen::Matrix4d V;
  V << Eigen::Matrix3d(J_hat.transpose() * M_inv * J_hat * params.dt), Vector3(0, 1, 1),
       params.mu, -1, -1, 0;

  Eigen::Vector4d p;
  p << J_n.dot((1 + params.epsilon) * v + params.dt * M_inv * f_e),
      -J_t.dot(v + params.dt * M_inv * f_e),
      J_t.dot(v + params.dt * M_inv * f_e),
      0;
  return {V, p};
}

}  // namespace bounce
