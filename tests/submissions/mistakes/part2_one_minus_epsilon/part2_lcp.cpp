#include <bounce/part2_lcp.hpp>

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  const Vector3 t = J.col(0);
  const Vector3 n = J.col(1);
  const Eigen::Matrix3d W = params.M().inverse();
  const Vector3 dv = params.dt * W * (params.M() * params.g);

  Eigen::Matrix3d D;
  D << n, -t, t;
  Lcp out;
  out.V << params.dt * D.transpose() * W * D, Vector3(0, 1, 1),
      Eigen::RowVector4d(params.mu, -1, -1, 0);
  out.p << n.dot((1 - params.epsilon) * v + dv), -t.dot(v + dv), t.dot(v + dv), 0;
  return out;
}

}  // namespace bounce
