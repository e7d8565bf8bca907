#include <bounce/part1_contacts.hpp>
#include <cmath>

namespace bounce {

// The corners lie on a circle around the centre, a quarter turn apart. Taking whole quarter turns
// off theta leaves an angle in [0, 90 deg), where the lower left corner, at 225 deg, is lowest.
Contact get_contacts(const Vector3& q, const Parameters& params) {
  const double quarter = M_PI / 2;
  const double rest = q(2) - quarter * std::floor(q(2) / quarter);
  const double angle = rest + 5 * M_PI / 4;
  const double radius = params.l / std::sqrt(2.0);

  const double r_x = radius * std::cos(angle);
  const double r_y = radius * std::sin(angle);

  Jacobian J;
  J << 1, 0,
       0, 1,
       -r_y, r_x;
  return {J, q(1) + r_y};
}

}  // namespace bounce
