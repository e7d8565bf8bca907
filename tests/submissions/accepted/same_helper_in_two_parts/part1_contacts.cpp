#include <bounce/part1_contacts.hpp>
#include <cmath>

namespace bounce {

// how far the lowest corner is below the centre
double drop(double theta, double l) {
  return l / 2 * (std::abs(std::sin(theta)) + std::abs(std::cos(theta)));
}

Contact get_contacts(const Vector3& q, const Parameters& params) {
  const double c = std::cos(q(2)), s = std::sin(q(2));
  const double i = s > 0 ? -1 : 1;
  const double j = c > 0 ? -1 : 1;
  const double r_x = params.l / 2 * (c * i - s * j);
  const double r_y = -drop(q(2), params.l);
  Contact contact;
  contact.J << 1, 0, 0, 1, -r_y, r_x;
  contact.phi = q(1) + r_y;
  return contact;
}

}  // namespace bounce
