#include <bounce/part2_lcp.hpp>

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  // weight points down
  const Vector3 f_e = -params.m * params.g;

  const Eigen::Matrix3d Mi = params.M().inverse();
  Eigen::Matrix3d Jhat;
  Jhat << J.col(1), -J.col(0), J.col(0);

  Lcp out;
  out.V.setZero();
  out.V.topLeftCorner<3, 3>() = params.dt * (Jhat.transpose() * Mi * Jhat);
  out.V(1, 3) = out.V(2, 3) = 1.0;
  out.V(3, 0) = params.mu;
  out.V(3, 1) = out.V(3, 2) = -1.0;

  out.p.setZero();
  out.p.head<3>() = Jhat.transpose() * (v + params.dt * Mi * f_e);
  out.p(0) += params.epsilon * J.col(1).dot(v);
  return out;
}

}  // namespace bounce
