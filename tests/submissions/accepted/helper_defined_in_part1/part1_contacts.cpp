#include <bounce/part1_contacts.hpp>
#include <cmath>

#include "corners.hpp"

Eigen::Vector2d corner(int k, const bounce::Vector3& q, const bounce::Parameters& params) {
  const double a = q(2) + M_PI / 4 + k * M_PI / 2;
  return q.head<2>() + params.l / std::sqrt(2.0) * Eigen::Vector2d(std::cos(a), std::sin(a));
}

int lowest_corner(const bounce::Vector3& q, const bounce::Parameters& params) {
  int lowest = 0;
  for (int k = 1; k < 4; ++k) {
    if (corner(k, q, params).y() < corner(lowest, q, params).y()) lowest = k;
  }
  return lowest;
}

namespace bounce {

Contact get_contacts(const Vector3& q, const Parameters& params) {
  const Eigen::Vector2d c = corner(lowest_corner(q, params), q, params);
  const Eigen::Vector2d r = c - q.head<2>();
  Contact contact;
  contact.J << 1, 0, 0, 1, -r.y(), r.x();
  contact.phi = c.y();
  return contact;
}

}  // namespace bounce
