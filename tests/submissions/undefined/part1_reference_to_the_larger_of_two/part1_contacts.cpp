#include <algorithm>
#include <cmath>

#include <bounce/part1_contacts.hpp>

namespace bounce {

// Two neighbouring corners; the other two are opposite to them.
Contact get_contacts(const Vector3& q, const Parameters& params) {
  const double c = std::cos(q(2)) * params.l / 2, s = std::sin(q(2)) * params.l / 2;
  const Eigen::Vector2d first(c - s, s + c), second(-c - s, -s + c);

  const auto& up = std::max(std::abs(first.y()), std::abs(second.y()));
  Eigen::Vector2d r = std::abs(first.y()) < up ? second : first;
  if (r.y() > 0) r = -r;

  Contact contact;
  contact.J << 1, 0, 0, 1, -r.y(), r.x();
  contact.phi = q(1) + r.y();
  return contact;
}

}  // namespace bounce
