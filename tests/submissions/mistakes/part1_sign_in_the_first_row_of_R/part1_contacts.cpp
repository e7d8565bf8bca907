#include <bounce/part1_contacts.hpp>
#include <cmath>

namespace bounce {

Contact get_contacts(const Vector3& q, const Parameters& params) {
  const double theta = q(2);
  const double h = params.l / 2;

  Eigen::Matrix2d R;
  R << std::cos(theta), std::sin(theta),
       std::sin(theta), std::cos(theta);

  Eigen::Matrix<double, 2, 4> corners;
  corners << h, -h, -h, h,
             h, h, -h, -h;
  corners = (R * corners).eval();

  int k_min = 0;
  for (int k = 1; k < 4; ++k) {
    if (corners(1, k) < corners(1, k_min)) k_min = k;
  }
  const double r_x = corners(0, k_min);
  const double r_y = corners(1, k_min);

  Contact contact;
  contact.J.col(0) << 1, 0, -r_y;
  contact.J.col(1) << 0, 1, r_x;
  contact.phi = q(1) + r_y;
  return contact;
}

}  // namespace bounce
