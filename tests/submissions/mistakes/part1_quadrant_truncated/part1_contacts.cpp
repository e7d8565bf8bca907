#include <bounce/part1_contacts.hpp>

#include <cmath>
#include <numbers>

namespace bounce {

using std::numbers::pi;

// The square looks the same after every quarter turn, so the lowest corner is found from the
// quadrant that theta is in.
Contact get_contacts(const Vector3& q, const Parameters& params) {
  const double radius = params.l / std::sqrt(2.0);
  const int quadrant = static_cast<int>(q(2) / (pi / 2));
  const double angle = q(2) - quadrant * pi / 2 - 0.75 * pi;

  const double r_x = radius * std::cos(angle);
  const double r_y = radius * std::sin(angle);

  Contact contact;
  contact.J << 1, 0, 0, 1, -r_y, r_x;
  contact.phi = q(1) + r_y;
  return contact;
}

}  // namespace bounce
