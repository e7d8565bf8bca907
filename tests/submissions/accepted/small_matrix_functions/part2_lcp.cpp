#include <bounce/part2_lcp.hpp>

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  // J_hat = [J_n -J_t J_t] = J * D
  Eigen::Matrix<double, 2, 3> D;
  D << 0, -1, 1,
       1, 0, 0;
  const Eigen::Matrix3d Jhat = J * D;
  const Eigen::Matrix3d Minv = params.M().inverse();
  const Vector3 e(0, 1, 1);
  const Eigen::RowVector3d cone(params.mu, -1, -1);

  Lcp lcp;
  lcp.V << params.dt * Jhat.transpose() * Minv * Jhat, e,
           cone, 0.0;

  // u = v + dt M^-1 f_e, and the restitution on top in the normal row
  const Vector3 u = v + params.dt * params.g;
  lcp.p << Jhat.transpose() * u, 0.0;
  lcp.p(0) += params.epsilon * J.col(1).dot(v);
  return lcp;
}

}  // namespace bounce
