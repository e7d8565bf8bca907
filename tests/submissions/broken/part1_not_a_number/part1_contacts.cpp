#include <bounce/part1_contacts.hpp>
#include <cmath>

namespace bounce {

Contact get_contacts(const Vector3& q, const Parameters& params) {
  // angle between the side and the diagonal
  const double half_diagonal = params.l / std::sqrt(2.0);
  const double alpha = std::asin(params.l / half_diagonal);

  double r_x = 0, r_y = 1e9;
  for (int k = 0; k < 4; ++k) {
    const double a = q(2) + alpha + k * M_PI / 2;
    if (!(half_diagonal * std::sin(a) > r_y)) {
      r_x = half_diagonal * std::cos(a);
      r_y = half_diagonal * std::sin(a);
    }
  }
  Contact contact;
  contact.J << 1, 0, 0, 1, -r_y, r_x;
  contact.phi = q(1) + r_y;
  return contact;
}

}  // namespace bounce
