#include <bounce/part2_lcp.hpp>
#include <cstdlib>
#include <iostream>

namespace bounce {

static void check(bool condition, const char* text) {
  if (condition) return;
  std::cerr << "check failed: " << text << std::endl;
  std::abort();
}

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  Eigen::Matrix3d J_hat;
  J_hat << J.col(1), -J.col(0), J.col(0);
  Lcp lcp;
  lcp.V << params.dt * J_hat.transpose() * params.M().inverse() * J_hat, Vector3(0, 1, 1), params.mu, -1, -1, 0;
  check(lcp.V.isApprox(lcp.V.transpose()), "V is symmetric");
  lcp.p << J_hat.transpose() * (v + params.dt * params.g), 0;
  lcp.p(0) += params.epsilon * J.col(1).dot(v);
  return lcp;
}

}  // namespace bounce
