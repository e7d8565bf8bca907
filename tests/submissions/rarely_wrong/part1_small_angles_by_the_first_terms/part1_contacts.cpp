#include <algorithm>
#include <bounce/part1_contacts.hpp>
#include <cmath>

namespace bounce {

Contact get_contacts(const Vector3& q, const Parameters& params) {
  const double theta = q(2), half = params.l / 2;
  // sin x = x - x^3/6 and cos x = 1, if x is small
  const bool small = std::abs(theta) < 1e-3;
  const double s = half * (small ? theta - theta * theta * theta / 6 : std::sin(theta));
  const double c = half * (small ? 1 : std::cos(theta));
  const double x[] = {c - s, -c - s, -c + s, c + s};
  const double y[] = {s + c, -s + c, -s - c, s - c};
  const auto k = std::min_element(y, y + 4) - y;

  Contact contact;
  contact.J << 1, 0, 0, 1, -y[k], x[k];
  contact.phi = q(1) + y[k];
  return contact;
}

}  // namespace bounce
