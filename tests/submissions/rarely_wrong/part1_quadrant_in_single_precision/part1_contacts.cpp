#include <bounce/part1_contacts.hpp>
#include <cmath>

namespace bounce {

Contact get_contacts(const Vector3& q, const Parameters& params) {
  const double quarter = std::acos(0.0);
  const float theta = q(2);
  const double quadrant = std::floor(theta / quarter);

  // The corner that points down to the left when the square is turned by less than 90 degrees.
  const double angle = q(2) - quadrant * quarter + 5 * quarter / 2;
  const double r_x = params.l / std::sqrt(2) * std::cos(angle);
  const double r_y = params.l / std::sqrt(2) * std::sin(angle);
  return {(Jacobian() << 1, 0, 0, 1, -r_y, r_x).finished(), q(1) + r_y};
}

}  // namespace bounce
