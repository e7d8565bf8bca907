#include <bounce/part1_contacts.hpp>
#include <cmath>
#include <limits>

namespace bounce {

Contact get_contacts(const Vector3& q, const Parameters& params) {
  const double s_x[4] = {1, -1, -1, 1};
  const double s_y[4] = {1, 1, -1, -1};
  const double c = std::cos(q(2)), s = std::sin(q(2));

  Contact contact;
  contact.phi = std::numeric_limits<double>::infinity();
  for (int k = 1; k < 4; k++) {
    const double r_x = params.l / 2 * (c * s_x[k] - s * s_y[k]);
    const double r_y = params.l / 2 * (s * s_x[k] + c * s_y[k]);
    if (q(1) + r_y < contact.phi) {
      contact.phi = q(1) + r_y;
      contact.J << 1, 0, 0, 1, -r_y, r_x;
    }
  }
  return contact;
}

}  // namespace bounce
