#include <bounce/part1_contacts.hpp>
#include <cmath>
#include <numbers>

// The square looks the same after each quarter turn. What is left of theta lies in [-45, 45] degrees,
// and there the lowest corner is one of the two that were below at first.
namespace bounce {

Contact get_contacts(const Vector3& q, const Parameters& params) {
  const double left = std::remainder(q(2), std::numbers::pi / 2);
  const double h = params.l / 2, c = std::cos(left), s = std::sin(left);
  const double side = left > 0 ? -1 : 1;  // turned to the left, the left corner goes down
  const double x = side * h * c + h * s;
  const double y = side * h * s - h * c;

  Contact contact;
  contact.J.col(0) = Vector3(1, 0, -y);
  contact.J.col(1) = Vector3(0, 1, x);
  contact.phi = q(1) + y;
  return contact;
}

}  // namespace bounce
