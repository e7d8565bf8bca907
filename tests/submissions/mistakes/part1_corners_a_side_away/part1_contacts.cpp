#include <bounce/part1_contacts.hpp>

#include <cmath>

namespace bounce {

Contact get_contacts(const Vector3& q, const Parameters& params) {
  const double l = params.l;
  const double c = std::cos(q(2)), s = std::sin(q(2));

  double phi = 1e9;
  double rx = 0;
  double ry = 0;
  for (double sx : {-l, l}) {
    for (double sy : {-l, l}) {
      const double x = c * sx - s * sy;
      const double y = s * sx + c * sy;
      if (q(1) + y < phi) {
        phi = q(1) + y;
        rx = x;
        ry = y;
      }
    }
  }

  Jacobian J;
  J.col(0) << 1, 0, -ry;
  J.col(1) << 0, 1, rx;
  return {J, phi};
}

}  // namespace bounce
