#include <bounce/part1_contacts.hpp>
#include <cmath>
#include <vector>

namespace bounce {

Contact get_contacts(const Vector3& q, const Parameters& params) {
  static std::vector<Eigen::Vector2d> s;  // in the frame of the square
  if (s.empty()) {
    const double h = params.l / 2;
    s = {{h, h}, {-h, h}, {-h, -h}, {h, -h}};
  }

  Eigen::Matrix2d R;
  R << std::cos(q(2)), -std::sin(q(2)), std::sin(q(2)), std::cos(q(2));

  Eigen::Vector2d r = R * s[0];
  for (const Eigen::Vector2d& corner : s) {
    const Eigen::Vector2d turned = R * corner;
    if (turned.y() < r.y()) r = turned;
  }

  Contact contact;
  contact.J << 1, 0, 0, 1, -r.y(), r.x();
  contact.phi = q.y() + r.y();
  return contact;
}

}  // namespace bounce
