#include <bounce/part1_contacts.hpp>
#include <cmath>

namespace bounce {

Contact get_contacts(const Vector3& q, const Parameters& params) {
  const double h = params.l / 2;
  Eigen::Matrix2d R;
  R << std::cos(q(2)), -std::sin(q(2)),
       std::sin(q(2)),  std::cos(q(2));

  Eigen::Matrix<double, 2, 4> corners;
  corners << h, h, -h, -h,
             h, -h, h, -h;
  corners = (R * corners).eval();
  corners.colwise() += q.head<2>();

  int i;
  double phi = corners.row(1).minCoeff(&i);
  Eigen::Vector2d r = corners.col(i);

  Jacobian J;
  J.col(0) = Vector3(1, 0, -r.y());
  J.col(1) = Vector3(0, 1, r.x());
  return {J, phi};
}

}
