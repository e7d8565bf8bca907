#include <bounce/part2_lcp.hpp>

namespace bounce {

namespace {

// B^T diag(w) B for any number of columns
template <int N>
Eigen::Matrix<double, N, N> gram(const Eigen::Matrix<double, 3, N>& B, const Vector3& w) {
  Eigen::Matrix<double, N, N> G;
  for (int i = 0; i < N; ++i) {
    for (int j = 0; j < N; ++j) G(i, j) = (B.col(i).cwiseProduct(w)).dot(B.col(j));
  }
  return G;
}

}  // namespace

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  const Vector3 w = params.M().diagonal().cwiseInverse();
  const Vector3 impulse = params.M() * params.g * params.dt;
  Eigen::Matrix<double, 3, 3> B;
  B << J.col(1), -J.col(0), J.col(0);

  Lcp lcp;
  lcp.V.setZero();
  lcp.V.template block<3, 3>(0, 0) = params.dt * gram<3>(B, w);
  lcp.V.template block<3, 1>(0, 3) = Vector3(0, 1, 1);
  lcp.V.template block<1, 3>(3, 0) = Eigen::RowVector3d(params.mu, -1, -1);

  const Vector3 scale(1 + params.epsilon, 1, 1);
  lcp.p.template head<3>() =
      scale.cwiseProduct(B.transpose() * v) + B.transpose() * w.cwiseProduct(impulse);
  lcp.p(3) = 0;
  return lcp;
}

}  // namespace bounce
