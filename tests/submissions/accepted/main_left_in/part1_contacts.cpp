#include <bounce/part1_contacts.hpp>
#include <cmath>
#include <iostream>

namespace bounce {

Contact get_contacts(const Vector3& q, const Parameters& params) {
  const double c = std::cos(q(2)), s = std::sin(q(2));
  Eigen::Vector2d r(0, 0);
  for (double x : {-params.l / 2, params.l / 2}) {
    for (double y : {-params.l / 2, params.l / 2}) {
      if (s * x + c * y < r(1)) r << c * x - s * y, s * x + c * y;
    }
  }
  Jacobian J;
  J << 1, 0, 0, 1, -r(1), r(0);
  return {J, q(1) + r(1)};
}

}  // namespace bounce

// quick test
int main() {
  const bounce::Contact c = bounce::get_contacts({0, 1.5, M_PI / 6}, bounce::Parameters());
  std::cout << c.J << "\n" << c.phi << "\n";
  return 0;
}
