#include <bounce/part2_lcp.hpp>
#include <iostream>

#define SHOW(x) std::cout << #x << " =\n" << (x) << "\n"

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  for (int i = 0; i < 100; ++i) std::cout << "---------- form_lcp ----------\n";
  Eigen::Matrix3d J_hat;
  J_hat << J.col(1), -J.col(0), J.col(0);
  SHOW(J);
  SHOW(J_hat);
  SHOW(v);
  const Eigen::Matrix3d M_inv = params.M().inverse();
  SHOW(M_inv);
  const Vector3 f_e = params.M() * params.g;
  SHOW(f_e);

  Lcp lcp;
  lcp.V << J_hat.transpose() * M_inv * J_hat * params.dt, Vector3(0, 1, 1), params.mu, -1, -1, 0;
  const Vector3 v_free = v + params.dt * M_inv * f_e;
  lcp.p << J.col(1).dot(v_free + params.epsilon * v), -J.col(0).dot(v_free), J.col(0).dot(v_free), 0;
  SHOW(lcp.V);
  SHOW(lcp.p);
  std::cout.flush();
  return lcp;
}

}  // namespace bounce
