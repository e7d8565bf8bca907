#include <bounce/part2_lcp.hpp>

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  const auto M = params.M();
  const Vector3 f_e = M * params.g;
  const Vector3 jt = J.col(0);
  const Vector3 jn = J.col(1);
  Eigen::Matrix3d jhat;
  jhat.col(0) = jn;
  jhat.col(1) = -jt;
  jhat.col(2) = jt;

  Lcp result;
  result.V.topLeftCorner(3, 3) = jhat.transpose() * M * jhat * params.dt;
  result.V.col(3) << 0, 1, 1, 0;
  result.V.row(3) << params.mu, -1, -1, 0;

  const Vector3 vnew = v + params.dt * M * f_e;
  result.p << jn.dot((1 + params.epsilon) * v + params.dt * M * f_e), -jt.dot(vnew), jt.dot(vnew), 0;
  return result;
}

}  // namespace bounce
