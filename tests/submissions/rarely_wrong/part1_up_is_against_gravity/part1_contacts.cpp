#include <bounce/part1_contacts.hpp>

#include <cmath>

namespace bounce {

Contact get_contacts(const Vector3& q, const Parameters& params) {
  Eigen::Vector2d up(0, 1);
  if (params.g.head<2>().norm() > 0) up = -params.g.head<2>().normalized();

  const double c = std::cos(q(2)), s = std::sin(q(2)), h = params.l / 2;
  Eigen::Vector2d lowest(0, 0);
  double height = INFINITY;
  for (double a : {-h, h}) {
    for (double b : {-h, h}) {
      const Eigen::Vector2d r(c * a - s * b, s * a + c * b);
      if (r.dot(up) < height) {
        height = r.dot(up);
        lowest = r;
      }
    }
  }

  const Eigen::Vector2d along(up.y(), -up.x());
  Contact contact;
  contact.phi = q.head<2>().dot(up) + height;
  contact.J << along.x(), up.x(),
               along.y(), up.y(),
               lowest.x() * along.y() - lowest.y() * along.x(), lowest.x() * up.y() - lowest.y() * up.x();
  return contact;
}

}  // namespace bounce
