#include <bounce/part1_contacts.hpp>

namespace bounce {

Contact get_contacts(const Vector3& q, const Parameters& params) {
  const Eigen::Matrix<double, 2, 4> r =
      params.l / 2 * Eigen::Rotation2Dd(q(2)).toRotationMatrix() *
      (Eigen::Matrix<double, 2, 4>() << 1, -1, -1, 1, 1, 1, -1, -1).finished();
  Eigen::Index k;
  r.row(1).minCoeff(&k);
  return {(Jacobian() << Eigen::Matrix2d::Identity(), r.col(k).reverse().cwiseProduct(Eigen::Vector2d(-1, 1)).transpose()).finished(),
          q(1) + r(1, k)};
}

}  // namespace bounce
