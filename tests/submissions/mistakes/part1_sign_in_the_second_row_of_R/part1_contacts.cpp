#include <bounce/part1_contacts.hpp>

#include <array>
#include <cmath>

namespace bounce {

Contact get_contacts(const Vector3& q, const Parameters& params) {
  const double c = std::cos(q.z()), s = std::sin(q.z()), a = 0.5 * params.l;
  const std::array<std::array<double, 2>, 4> body = {{{a, a}, {-a, a}, {-a, -a}, {a, -a}}};

  double r_x = 0, r_y = 0;
  for (const auto& b : body) {
    const double x = c * b[0] - s * b[1];
    const double y = -s * b[0] + c * b[1];
    if (y < r_y) {
      r_x = x;
      r_y = y;
    }
  }

  Contact contact;
  contact.J << 1, 0,
               0, 1,
               -r_y, r_x;
  contact.phi = q.y() + r_y;
  return contact;
}

}  // namespace bounce
