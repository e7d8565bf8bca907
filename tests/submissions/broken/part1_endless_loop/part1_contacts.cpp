#include <bounce/part1_contacts.hpp>
#include <cmath>

namespace bounce {

// goes round the square once, a quarter turn at a time
Contact get_contacts(const Vector3& q, const Parameters& params) {
  const double full = 6.28318;
  const double quarter = 3.14159265 / 2;
  const double radius = params.l / std::sqrt(2.0);

  double r_x = 0, r_y = 0;
  for (double a = 0; a != full; a += quarter) {
    const double y = radius * std::sin(q(2) + quarter / 2 + a);
    if (y < r_y) {
      r_x = radius * std::cos(q(2) + quarter / 2 + a);
      r_y = y;
    }
  }

  Contact contact;
  contact.J << 1, 0, 0, 1, -r_y, r_x;
  contact.phi = q(1) + r_y;
  return contact;
}

}  // namespace bounce
