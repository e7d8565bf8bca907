#include <bounce/part2_lcp.hpp>

namespace {
const double MASS = 0.3;
const double EPSILON = 0.5;
}  // namespace

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  const double inertia = MASS * params.l * params.l / 6;
  const Eigen::Matrix3d M_inv = Vector3(1 / MASS, 1 / MASS, 1 / inertia).asDiagonal();
  const Vector3 f_e = MASS * params.g;

  const Vector3 J_t = J.col(0);
  const Vector3 J_n = J.col(1);
  Eigen::Matrix3d J_hat;
  J_hat << J_n, -J_t, J_t;
  const Vector3 accel = M_inv * f_e;

  Lcp lcp;
  lcp.V.block<3, 3>(0, 0) = J_hat.transpose() * M_inv * J_hat * params.dt;
  lcp.V.block<3, 1>(0, 3) = Vector3(0, 1, 1);
  lcp.V.block<1, 4>(3, 0) << params.mu, -1, -1, 0;
  lcp.p << J_n.dot((1 + EPSILON) * v + params.dt * accel), -J_t.dot(v + params.dt * accel),
      J_t.dot(v + params.dt * accel), 0;
  return lcp;
}

}  // namespace bounce
