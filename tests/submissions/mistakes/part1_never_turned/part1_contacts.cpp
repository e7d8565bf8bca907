#include <Eigen/Geometry>
#include <bounce/part1_contacts.hpp>

namespace bounce {

Contact get_contacts(const Vector3& q, const Parameters& params) {

  Eigen::Matrix<double, 2, 4> s;
  s << 1, -1, -1, 1,
      1, 1, -1, -1;
  const Eigen::Matrix2d R = Eigen::Rotation2Dd(0.0).toRotationMatrix();
  const Eigen::Matrix<double, 2, 4> r_k = R * s * (params.l / 2);

  Eigen::Index lowest = 0;
  r_k.row(1).minCoeff(&lowest);
  const Eigen::Vector2d r = r_k.col(lowest);

  const Vector3 J_t(1, 0, -r.y());
  const Vector3 J_n(0, 1, r.x());
  Jacobian J;
  J << J_t, J_n;
  return {J, q(1) + r.y()};
}

}
