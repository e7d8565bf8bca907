#include <bounce/part2_lcp.hpp>

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  const Vector3 t = J.col(0);
  const Vector3 n = J.col(1);
  const double v_t = t.dot(v);
  const double v_n = n.dot(v);

  Eigen::Matrix3d Jhat;
  Jhat << n, -t, t;
  const Eigen::Matrix3d A = Jhat.transpose() * params.M().inverse() * Jhat * params.dt;

  Eigen::Matrix4d V;
  V << A(0, 0), A(0, 1), A(0, 2), 0,
       A(1, 0), A(1, 1), A(1, 2), 1,
       A(2, 0), A(2, 1), A(2, 2), 1,
       params.mu, -1, -1, 0;
  return {V, Eigen::Vector4d((1 + params.epsilon) * v_n, -v_t, v_t, 0)};
}

}  // namespace bounce
