#include <bounce/part1_contacts.hpp>
#include <cmath>

namespace bounce {

Contact get_contacts(const Vector3& q, const Parameters& params) {
  // corners: 0 = top right, 1 = top left, 2 = bottom left, 3 = bottom right
  static const int sx[] = {+1, -1, -1, +1};
  static const int sy[] = {+1, +1, -1, -1};

  int lowest = -1;
  double r_x[4], r_y[4];
  for (int k = 0; k < 4; ++k) {
    r_x[k] = params.l / 2 * (sx[k] * std::cos(q(2)) - sy[k] * std::sin(q(2)));
    r_y[k] = params.l / 2 * (sx[k] * std::sin(q(2)) + sy[k] * std::cos(q(2)));
    if (lowest < 0 || r_y[k] < r_y[lowest]) lowest = k;
  }

  Jacobian J = Jacobian::Zero();
  J(0, 0) = 1.0;
  J(1, 1) = 1.0;
  J(2, 0) = -r_y[lowest];
  J(2, 1) = -r_x[lowest];
  return Contact{J, q(1) + r_y[lowest]};
}

}  // namespace bounce
