#include <bounce/part2_lcp.hpp>
#include <iostream>

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  double mu = -1;
  std::cout << "mu = ";
  std::cin >> mu;

  Eigen::Matrix3d J_hat;
  J_hat << J.col(1), -J.col(0), J.col(0);
  Lcp lcp;
  lcp.V << params.dt * J_hat.transpose() * params.M().inverse() * J_hat, Vector3(0, 1, 1), mu, -1, -1, 0;
  lcp.p << J_hat.transpose() * (v + params.dt * params.g), 0;
  lcp.p(0) += params.epsilon * J.col(1).dot(v);
  return lcp;
}

}  // namespace bounce
