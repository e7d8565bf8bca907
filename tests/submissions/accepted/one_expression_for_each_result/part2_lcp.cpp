#include <bounce/part2_lcp.hpp>

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  const Eigen::Matrix3d B = (Eigen::Matrix3d() << J.col(1), -J.leftCols<1>(), J.leftCols<1>()).finished();
  return {(Eigen::Matrix4d() << B.transpose() * (params.dt * params.M().diagonal().cwiseInverse()).asDiagonal() * B,
                                Vector3::Ones() - Vector3::UnitX(),
                                Eigen::RowVector3d(params.mu, -1, -1), 0.0).finished(),
          (Eigen::Vector4d() << B.transpose() * (v + params.dt * params.g) +
                                    params.epsilon * J.rightCols<1>().dot(v) * Vector3::UnitX(),
                                0.0).finished()};
}

}  // namespace bounce
