#include <bounce/part1_contacts.hpp>
#include <cmath>
#include <limits>

namespace bounce {

Contact get_contacts(const Vector3& q, const Parameters& params) {
  const double half = params.l / 2;
  const double c = std::cos(q(2));
  const double s = std::sin(q(2));

  double phi = std::numeric_limits<double>::infinity();
  double r_x = 0;
  double r_y = 0;
  for (int i = -1; i <= 1; i += 2) {
    for (int j = -1; j <= 1; j += 2) {
      const double x = c * i * half - s * j * half;
      const double y = s * i * half + c * j * half;
      if (q(1) + y < phi) {
        phi = q(1) + y;
        r_x = x;
        r_y = y;
      }
    }
  }

  Jacobian J;
  J << 1, 0,
       0, 1,
       -r_y, r_x;
  return {J, phi};
}

}  // namespace bounce
