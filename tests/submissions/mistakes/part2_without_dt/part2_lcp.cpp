#include <bounce/part2_lcp.hpp>

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  Eigen::Matrix3d Jh;
  Jh << J.col(1), -J.col(0), J.col(0);
  const Eigen::Matrix3d Minv = params.M().inverse();

  Eigen::Matrix4d V;
  V.setZero();
  V.block(0, 0, 3, 3) = Jh.transpose() * Minv * Jh;
  V(1, 3) = 1;
  V(2, 3) = 1;
  V.row(3) << params.mu, -1, -1, 0;

  const Vector3 fe = params.M() * params.g;
  const Vector3 free = v + params.dt * (Minv * fe);
  Eigen::Vector4d p;
  p.head(3) = Jh.transpose() * free;
  p(0) += params.epsilon * J.col(1).dot(v);
  p(3) = 0;
  return {V, p};
}

}  // namespace bounce
