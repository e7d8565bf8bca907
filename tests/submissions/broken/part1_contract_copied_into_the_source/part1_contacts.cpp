#include <bounce/part1_contacts.hpp>
#include <cmath>

namespace bounce {

struct Contact {
  Jacobian J;
  double phi;
};

Contact get_contacts(const Vector3& q, const Parameters& params) {
  const double c = std::cos(q(2)), s = std::sin(q(2));
  const double i = s > 0 ? -params.l / 2 : params.l / 2;
  const double j = c > 0 ? -params.l / 2 : params.l / 2;
  Contact contact;
  contact.J << 1, 0, 0, 1, -(s * i + c * j), c * i - s * j;
  contact.phi = q(1) + s * i + c * j;
  return contact;
}

}  // namespace bounce
