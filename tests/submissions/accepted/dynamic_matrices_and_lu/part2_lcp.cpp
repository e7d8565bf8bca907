#include <bounce/part2_lcp.hpp>

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  Eigen::MatrixXd M = params.M();
  Eigen::VectorXd f_e = M * params.g;
  Eigen::MatrixXd J_hat(3, 3);
  J_hat << J.col(1), -J.col(0), J.col(0);

  Eigen::MatrixXd V = Eigen::MatrixXd::Zero(4, 4);
  V.topLeftCorner(3, 3) = J_hat.transpose() * M.fullPivLu().solve(J_hat) * params.dt;
  V.block(1, 3, 2, 1).setOnes();
  V.bottomLeftCorner(1, 3) << params.mu, -1, -1;

  Eigen::VectorXd p(4);
  Eigen::VectorXd v_free = v + params.dt * M.partialPivLu().solve(f_e);
  p << J.col(1).dot(v_free) + params.epsilon * J.col(1).dot(v), -J.col(0).dot(v_free), J.col(0).dot(v_free), 0;
  return {V, p};
}

}  // namespace bounce
