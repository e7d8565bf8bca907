#include <bounce/part1_contacts.hpp>
#include <cmath>

namespace bounce {

// A 3 x 3 matrix moves all four corners at once, each with a third coordinate of 1.
Contact get_contacts(const Vector3& q, const Parameters& params) {
  Eigen::Matrix3d T = Eigen::Matrix3d::Identity();
  T(0, 0) = T(1, 1) = std::cos(q(2));
  T(1, 0) = std::sin(q(2));
  T(0, 1) = -T(1, 0);
  T.col(2).head(2) = q.head(2);

  Eigen::Matrix<double, 3, 4> corners;
  corners << 1, -1, -1, 1,
             1, 1, -1, -1,
             2 / params.l, 2 / params.l, 2 / params.l, 2 / params.l;
  corners *= params.l / 2;
  corners = (T * corners).eval();

  int i;
  const double phi = corners.row(1).minCoeff(&i);
  Jacobian J = Jacobian::Zero();
  J.topRows(2).setIdentity();
  J(2, 0) = q(1) - corners(1, i);
  J(2, 1) = corners(0, i) - q(0);
  return {J, phi};
}

}  // namespace bounce
