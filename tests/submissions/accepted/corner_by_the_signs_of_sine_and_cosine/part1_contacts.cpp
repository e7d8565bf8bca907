#include <bounce/part1_contacts.hpp>
#include <cmath>

namespace bounce {

// A corner's height over the centre is sin(theta) s_x + cos(theta) s_y: lowest where both terms
// are negative.
Contact get_contacts(const Vector3& q, const Parameters& params) {
  const double c = std::cos(q(2));
  const double s = std::sin(q(2));
  const double s_x = std::copysign(params.l / 2, -s);
  const double s_y = std::copysign(params.l / 2, -c);

  Contact contact;
  contact.phi = q(1) - params.l / 2 * (std::abs(s) + std::abs(c));
  contact.J.col(0) << 1, 0, -(s * s_x + c * s_y);
  contact.J.col(1) << 0, 1, c * s_x - s * s_y;
  return contact;
}

}  // namespace bounce
