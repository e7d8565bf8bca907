#include <bounce/part1_contacts.hpp>

namespace bounce {

// the contact is below the centre, l does not matter for a small square
Contact get_contacts(const Vector3& q, const Parameters&) {
  Jacobian J = Jacobian::Zero();
  J(0, 0) = 1;
  J(1, 1) = 1;
  return {J, q(1)};
}

}  // namespace bounce
