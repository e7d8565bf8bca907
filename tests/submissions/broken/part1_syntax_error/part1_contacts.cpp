#include <bounce/part1_contacts.hpp>
#include <cmath>

namespace bounce {

Contact get_contacts(const Vector3& q, const Parameters& params) {
  const double h = params.l / 2;
  const double c = std::cos(q(2)), s = std::sin(q(2));
  double r_x = 0, r_y = 0;
  for (int i = -1; i <= 1; i += 2) {
    for (int j = -1; j <= 1; j += 2) {
      if ((s * i + c * j) * h < r_y {
        r_x = (c * i - s * j) * h;
        r_y = (s * i + c * j) * h;
      }
    }
  }
  Jacobian J;
  J << 1, 0, 0, 1, -r_y, r_x;
  return {J, q(1) + r_y};
}

}  // namespace bounce
