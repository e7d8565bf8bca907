#include <bounce/part1_contacts.hpp>

#include <cmath>

namespace bounce {

const double LENGTH = 0.2;

Contact get_contacts(const Vector3& q, const Parameters& params) {
  (void)params;
  double x = q[0], y = q[1], theta = q[2];
  double c = std::cos(theta), s = std::sin(theta);
  double h = LENGTH / 2.0;

  double best_x = 0, best_y = 1e300;
  for (int i = -1; i <= 1; i += 2) {
    for (int j = -1; j <= 1; j += 2) {
      double cx = x + c * i * h - s * j * h;
      double cy = y + s * i * h + c * j * h;
      if (cy < best_y) {
        best_x = cx;
        best_y = cy;
      }
    }
  }

  double rx = best_x - x;
  double ry = best_y - y;
  Contact contact;
  contact.phi = best_y;
  contact.J << 1, 0,
               0, 1,
               -ry, rx;
  return contact;
}

}  // namespace bounce
