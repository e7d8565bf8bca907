#include <bounce/part2_lcp.hpp>
#include <cmath>

namespace bounce {

// In the coordinates M^(1/2) v the inertia is 1, and the block of V is B^T B dt.
Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  const Vector3 root = params.M().diagonal().cwiseSqrt();
  Eigen::Matrix3d J_hat;
  J_hat << J.col(1), -J.col(0), J.col(0);
  const Eigen::Matrix3d B = root.cwiseInverse().asDiagonal() * J_hat;
  const Vector3 u = root.cwiseProduct(v);
  const Vector3 h = root.cwiseProduct(params.g);

  Eigen::Matrix4d V = Eigen::Matrix4d::Zero();
  V.topLeftCorner<3, 3>() = params.dt * (B.transpose() * B);
  V(3, 0) = params.mu;
  for (int k : {1, 2}) {
    V(3, k) = -1;
    V(k, 3) = 1;
  }

  Eigen::Vector4d p = Eigen::Vector4d::Zero();
  p.head<3>() = B.transpose() * (u + params.dt * h);
  p(0) += params.epsilon * B.col(0).dot(u);
  return {V, p};
}

}  // namespace bounce
