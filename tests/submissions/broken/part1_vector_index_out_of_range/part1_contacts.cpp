#include <bounce/part1_contacts.hpp>
#include <cmath>
#include <vector>

namespace bounce {

std::vector<Eigen::Vector2d> corners;

Contact get_contacts(const Vector3& q, const Parameters& params) {
  for (std::size_t k = 0; k < 4; ++k) {
    const double a = q(2) + M_PI / 4 + static_cast<double>(k) * M_PI / 2;
    corners[k] = params.l / std::sqrt(2.0) * Eigen::Vector2d(std::cos(a), std::sin(a));
  }

  std::size_t lowest = 0;
  for (std::size_t k = 1; k < 4; ++k) {
    if (corners[k].y() < corners[lowest].y()) lowest = k;
  }
  Contact contact;
  contact.J << 1, 0, 0, 1, -corners[lowest].y(), corners[lowest].x();
  contact.phi = q(1) + corners[lowest].y();
  return contact;
}

}  // namespace bounce
