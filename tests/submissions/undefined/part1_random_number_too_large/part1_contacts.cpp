#include <cmath>

#include <bounce/part1_contacts.hpp>

namespace bounce {

// Begins at any corner, so that no corner is preferred where two are equally low.
Contact get_contacts(const Vector3& q, const Parameters& params) {
  static int seed = 4711;
  seed = seed * 1103515245 + 12345;
  const int first = seed & 3;

  const double c = std::cos(q(2)), s = std::sin(q(2)), h = params.l / 2;
  const double x[4] = {h, -h, -h, h}, y[4] = {h, h, -h, -h};
  double rx = 0, ry = 0;
  for (int i = 0; i < 4; ++i) {
    const int k = (first + i) % 4;
    const double turned = s * x[k] + c * y[k];
    if (i == 0 || turned < ry) {
      rx = c * x[k] - s * y[k];
      ry = turned;
    }
  }
  Contact contact;
  contact.J << 1, 0, 0, 1, -ry, rx;
  contact.phi = q(1) + ry;
  return contact;
}

}  // namespace bounce
