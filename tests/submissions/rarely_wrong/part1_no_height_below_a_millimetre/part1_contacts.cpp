#include <algorithm>
#include <bounce/part1_contacts.hpp>
#include <cmath>

namespace bounce {

Contact get_contacts(const Vector3& q, const Parameters& params) {
  const double c = std::cos(q(2)) * params.l / 2, s = std::sin(q(2)) * params.l / 2;
  const double x[] = {c - s, -c - s, -c + s, c + s};
  const double y[] = {s + c, -s + c, -s - c, s - c};
  const auto k = std::min_element(y, y + 4) - y;
  double phi = q(1) + y[k];
  if (std::abs(phi) < 1e-3) phi = 0;  // it rests on the ground

  Jacobian J;
  J << 1, 0,
       0, 1,
       -y[k], x[k];
  return {J, phi};
}

}  // namespace bounce
