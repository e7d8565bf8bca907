#include <bounce/part1_contacts.hpp>
#include <cmath>

namespace bounce {

Contact get_contacts(const Vector3& q, const Parameters& params) {
  const float y = static_cast<float>(q(1));
  const float theta = static_cast<float>(q(2));
  const float h = static_cast<float>(params.l) / 2.0f;
  const float c = std::cos(theta);
  const float s = std::sin(theta);

  float rx = 0.0f, ry = 1e30f;
  for (int k = 0; k < 4; ++k) {
    const float sx = (k & 1) ? h : -h;
    const float sy = (k & 2) ? h : -h;
    const float cy = s * sx + c * sy;
    if (cy < ry) {
      rx = c * sx - s * sy;
      ry = cy;
    }
  }

  Contact contact;
  contact.J << 1.0f, 0.0f, 0.0f, 1.0f, -ry, rx;
  contact.phi = y + ry;
  return contact;
}

}  // namespace bounce
