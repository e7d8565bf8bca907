#include <bounce/part1_contacts.hpp>
#include <cmath>

namespace bounce {

Contact get_contacts(const Vector3& q, const Parameters& params) {
  Eigen::Matrix2d R;
  R << std::cos(q(2)), -std::sin(q(2)), std::sin(q(2)), std::cos(q(2));
  Eigen::Matrix<double, 2, 4> s;
  s << 1, -1, -1, 1, 1, 1, -1, -1;
  const Eigen::Matrix<double, 2, 4> c = (R * s * params.l / 2).colwise() + q.head<2>();

  double lowest = 0;
  int index = 0;
  for (int k = 0; k < 4; ++k) {
    if (c(1, k) < lowest) {
      lowest = c(1, k);
      index = k;
    }
  }
  const Eigen::Vector2d r = c.col(index) - q.head<2>();

  Contact contact;
  contact.phi = lowest;
  contact.J.col(0) << 1, 0, -r(1);
  contact.J.col(1) << 0, 1, r(0);
  return contact;
}

}  // namespace bounce
