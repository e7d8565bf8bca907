#include <bounce/part1_contacts.hpp>
#include <cmath>

namespace bounce {

Contact get_contacts(const Vector3& q, const Parameters& params) {
  const double a = params.l / 2;
  const double signs[4][2] = {{1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
  const Eigen::Vector2d centre(q(0), q(1));
  Eigen::Vector2d lowest(0, 1e300);
  for (const auto& s : signs) {
    const Eigen::Vector2d corner(
        q(0) + std::cos(q(2)) * a * s[0] - std::sin(q(2)) * a * s[1],
        q(1) + std::sin(q(2)) * a * s[0] + std::cos(q(2)) * a * s[1]);
    if (corner.y() < lowest.y()) lowest = corner;
  }
  const Eigen::Vector2d r = centre - lowest;
  Contact contact;
  contact.J.col(0) << 1, 0, -r.y();
  contact.J.col(1) << 0, 1, r.x();
  contact.phi = lowest.y();
  return contact;
}

}  // namespace bounce
