#include <bounce/part2_lcp.hpp>

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  // everything for (t, n) first, then spread over the rows and columns of the LCP
  const Eigen::Matrix3d Minv = params.M().inverse();
  const Eigen::Matrix2d A = params.dt * J.transpose() * Minv * J;
  const Eigen::Vector2d u = J.transpose() * v;
  const Eigen::Vector2d du = params.dt * J.transpose() * Minv * (params.M() * params.g);

  const int which[3] = {1, 0, 0};
  const double sign[3] = {1, -1, 1};
  Lcp lcp;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      lcp.V(i, j) = sign[i] * sign[j] * A(which[i], which[j]);
    }
    lcp.V(i, 3) = i == 0 ? 0 : 1;
    lcp.V(3, i) = i == 0 ? params.mu : -1;
    const double bounce = i == 0 ? 1 + params.epsilon : 1;
    lcp.p(i) = sign[i] * (bounce * u(which[i]) + du(which[i]));
  }
  lcp.V(3, 3) = 0;
  lcp.p(3) = 0;
  return lcp;
}

}  // namespace bounce
