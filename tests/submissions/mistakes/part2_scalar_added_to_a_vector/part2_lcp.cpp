#include <bounce/part2_lcp.hpp>

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  // arrays so that numbers and vectors can be mixed, as in numpy
  const Eigen::Array3d vel = v.array();
  const Eigen::Matrix3d M_inv = params.M().inverse();
  const Eigen::Array3d dv = (params.dt * M_inv * params.M() * params.g).array();

  const Vector3 J_t = J.col(0);
  const Vector3 J_n = J.col(1);
  Eigen::Matrix3d J_hat;
  J_hat << J_n, -J_t, J_t;

  Lcp lcp;
  lcp.V.topLeftCorner<3, 3>() = J_hat.transpose() * M_inv * J_hat * params.dt;
  lcp.V.col(3) << 0, 1, 1, 0;
  lcp.V.row(3) << params.mu, -1, -1, 0;

  const Eigen::Array3d before = (1 + params.epsilon * vel) + dv;
  const Eigen::Array3d slide = vel + dv;
  lcp.p(0) = J_n.dot(before.matrix());
  lcp.p(1) = -J_t.dot(slide.matrix());
  lcp.p(2) = J_t.dot(slide.matrix());
  lcp.p(3) = 0.0;
  return lcp;
}

}  // namespace bounce
