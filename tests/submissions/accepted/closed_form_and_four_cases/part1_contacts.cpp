#include <bounce/part1_contacts.hpp>
#include <cmath>

namespace bounce {

Contact get_contacts(const Vector3& q, const Parameters& params) {
  // A corner is at (sx, sy) * l/2 in the body. Its height above the centre is
  // l/2 (sx sin + sy cos), so the lowest has sx = -sign(sin) and sy = -sign(cos).
  const double s = std::sin(q(2));
  const double c = std::cos(q(2));
  const double sx = -std::copysign(1.0, s);
  const double sy = -std::copysign(1.0, c);
  const double rx = params.l / 2 * (c * sx - s * sy);
  const double ry = params.l / 2 * (s * sx + c * sy);

  Contact contact;
  contact.J << 1, 0, 0, 1, -ry, rx;
  contact.phi = q(1) + ry;
  return contact;
}

}  // namespace bounce
