#include <bounce/part1_contacts.hpp>
#include <cmath>

namespace bounce {

Contact get_contacts(const Vector3& q, const Parameters& params) {
  Eigen::Matrix2d R;
  R << std::cos(q(2)), -std::sin(q(2)), std::sin(q(2)), std::cos(q(2));

  Eigen::Matrix<double, 4, 2> corners;
  corners << 0.5, 0.5,
            -0.5, 0.5,
            -0.5, -0.5,
             0.5, -0.5;
  corners *= params.l;

  Eigen::Vector2d r = R * corners.row(0).transpose();
  for (int i = 1; i < corners.rows() - 1; ++i) {
    Eigen::Vector2d next = R * corners.row(i).transpose();
    if (next(1) < r(1)) r = next;
  }

  Jacobian J;
  J << 1, 0,
       0, 1,
       -r(1), r(0);
  return {J, q(1) + r(1)};
}

}  // namespace bounce
