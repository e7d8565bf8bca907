#include <bounce/part2_lcp.hpp>
#include <Eigen/Cholesky>

namespace bounce {

// M = L L^T, so J_hat^T M^-1 J_hat = A^T A with A = L^-1 J_hat.
Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  const Eigen::LLT<Eigen::Matrix3d> cholesky(params.M());
  Eigen::Matrix3d A;
  A << J.rightCols<1>(), -J.leftCols<1>(), J.leftCols<1>();
  const Vector3 b = A.transpose() * (v + params.dt * params.M().llt().solve(params.M() * params.g));
  cholesky.matrixL().solveInPlace(A);

  Lcp lcp{Eigen::Matrix4d::Zero(), Eigen::Vector4d::Zero()};
  lcp.V.block<3, 3>(0, 0).noalias() = params.dt * A.transpose() * A;
  lcp.V(1, 3) = lcp.V(2, 3) = 1;
  lcp.V.bottomRows<1>() = Eigen::RowVector4d(params.mu, -1, -1, 0);
  lcp.p.head<3>() = b;
  lcp.p[0] += params.epsilon * (J.transpose() * v)[1];
  return lcp;
}

}  // namespace bounce
