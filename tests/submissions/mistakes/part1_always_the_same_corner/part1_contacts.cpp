#include <bounce/part1_contacts.hpp>
#include <cmath>

namespace bounce {

Contact get_contacts(const Vector3& q, const Parameters& params) {
  double l = params.l;
  double theta = q(2);

  // lower left corner of the square, rotated with it
  double rx = -l / 2 * std::cos(theta) + l / 2 * std::sin(theta);
  double ry = -l / 2 * std::sin(theta) - l / 2 * std::cos(theta);

  Jacobian J;
  J(0, 0) = 1;
  J(1, 0) = 0;
  J(2, 0) = -ry;
  J(0, 1) = 0;
  J(1, 1) = 1;
  J(2, 1) = rx;

  return {J, q(1) + ry};
}

}  // namespace bounce
