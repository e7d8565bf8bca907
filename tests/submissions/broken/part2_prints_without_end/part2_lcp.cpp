#include <bounce/part2_lcp.hpp>
#include <iostream>
#include <string>

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  Eigen::Matrix3d J_hat;
  J_hat << J.col(1), -J.col(0), J.col(0);
  const std::string line(2000, '-');
  // from last to first
  for (unsigned int i = 2; i >= 0; --i) {
    std::cout << line << "\ncolumn " << i % 3 << " of J_hat: " << J_hat.col(i % 3).transpose() << "\n";
  }

  Lcp lcp;
  lcp.V << params.dt * J_hat.transpose() * params.M().inverse() * J_hat, Vector3(0, 1, 1), params.mu, -1, -1, 0;
  lcp.p << J_hat.transpose() * (v + params.dt * params.g), 0;
  lcp.p(0) += params.epsilon * J.col(1).dot(v);
  return lcp;
}

}  // namespace bounce
