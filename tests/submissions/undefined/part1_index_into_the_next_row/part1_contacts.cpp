#include <cmath>

#include <bounce/part1_contacts.hpp>

namespace bounce {

Contact get_contacts(const Vector3& q, const Parameters& params) {
  const double c = std::cos(q(2)), s = std::sin(q(2)), h = params.l / 2;
  const double body[4][2] = {{h, h}, {-h, h}, {-h, -h}, {h, -h}};

  double turned[4][2];
  for (int i = 0; i < 8; i += 2) {  // x and y of one corner after the other
    const double x = body[0][i], y = body[0][i + 1];
    turned[0][i] = c * x - s * y;
    turned[0][i + 1] = s * x + c * y;
  }

  int lowest = 0;
  for (int k = 1; k < 4; ++k) {
    if (turned[k][1] < turned[lowest][1]) lowest = k;
  }
  Contact contact;
  contact.J << 1, 0, 0, 1, -turned[lowest][1], turned[lowest][0];
  contact.phi = q(1) + turned[lowest][1];
  return contact;
}

}  // namespace bounce
