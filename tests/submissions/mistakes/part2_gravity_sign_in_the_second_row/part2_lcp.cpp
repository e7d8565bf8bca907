#include <bounce/part2_lcp.hpp>

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  const Eigen::Matrix3d M_inv = params.M().inverse();
  const Vector3 f_e = params.M() * params.g;
  const double dt = params.dt;
  const Vector3 Jt = J.col(0);
  const Vector3 Jn = J.col(1);

  Eigen::Matrix3d Jhat;
  Jhat << Jn, -Jt, Jt;

  Lcp lcp;
  lcp.V.setZero();
  lcp.V.block<3, 3>(0, 0) = Jhat.transpose() * M_inv * Jhat * dt;
  lcp.V.block<3, 1>(0, 3) << 0, 1, 1;
  lcp.V.block<1, 3>(3, 0) << params.mu, -1, -1;

  lcp.p(0) = Jn.transpose() * ((1 + params.epsilon) * v + dt * M_inv * f_e);
  lcp.p(1) = -Jt.dot(v) + dt * Jt.dot(M_inv * f_e);
  lcp.p(2) = Jt.dot(v) + dt * Jt.dot(M_inv * f_e);
  lcp.p(3) = 0;
  return lcp;
}

}  // namespace bounce
