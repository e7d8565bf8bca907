#include <bounce/part1_contacts.hpp>
#include <cmath>

namespace bounce {

Contact get_contacts(const Vector3& q, const Parameters& params) {
  const double c = std::cos(q(2)), s = std::sin(q(2));
  Eigen::Matrix2d R;
  R << c, -s, s, -c;
  const double h = params.l / 2;
  Eigen::Vector2d r(0, 0);
  for (int i : {-1, 1}) {
    for (int j : {-1, 1}) {
      const Eigen::Vector2d arm = R * Eigen::Vector2d(i * h, j * h);
      if (arm.y() < r.y()) r = arm;
    }
  }
  Contact contact;
  contact.J << 1, 0, 0, 1, -r.y(), r.x();
  contact.phi = q(1) + r.y();
  return contact;
}

}  // namespace bounce
