#include <bounce/part2_lcp.hpp>

namespace bounce {

// J_hat^T M^-1 J_hat is the sum over the three coordinates of what each adds by itself.
Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  const double masses[] = {params.m, params.m, params.m * params.l * params.l / 6};
  const Eigen::RowVector3d order[] = {{0, -1, 1}, {1, 0, 0}};  // of J_t and of J_n in J_hat

  Lcp lcp;
  lcp.V << Eigen::Matrix3d::Zero(), Eigen::Vector3d(0, 1, 1), Eigen::RowVector4d(params.mu, -1, -1, 0);
  lcp.p.setZero();
  for (int i = 0; i < 3; ++i) {
    const Eigen::RowVector3d row = J(i, 0) * order[0] + J(i, 1) * order[1];
    lcp.V.topLeftCorner<3, 3>() += params.dt / masses[i] * row.transpose() * row;
    lcp.p.head<3>() += row.transpose() * (v(i) + params.dt * params.g(i));
    lcp.p(0) += params.epsilon * J(i, 1) * v(i);
  }
  return lcp;
}

}  // namespace bounce
