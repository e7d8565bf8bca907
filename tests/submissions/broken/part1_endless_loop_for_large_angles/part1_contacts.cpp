#include <bounce/part1_contacts.hpp>
#include <cmath>

namespace bounce {

static double between_minus_pi_and_pi(double theta) {
  const double turn = 2 * M_PI;
  while (theta > M_PI) theta += turn;
  while (theta < -M_PI) theta -= turn;
  return theta;
}

Contact get_contacts(const Vector3& q, const Parameters& params) {
  const double theta = between_minus_pi_and_pi(q(2));
  const double c = std::cos(theta), s = std::sin(theta), h = params.l / 2;
  const double r_y = -h * (std::abs(s) + std::abs(c));
  const double r_x = h * (c * (s > 0 ? -1 : 1) - s * (c > 0 ? -1 : 1));
  Contact contact;
  contact.J << 1, 0, 0, 1, -r_y, r_x;
  contact.phi = q(1) + r_y;
  return contact;
}

}  // namespace bounce
