#include <bounce/part1_contacts.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace bounce {

Contact get_contacts(const Vector3& q, const Parameters& params) {
  const double half = params.l / 2;
  const double c = std::cos(q(2));
  const double s = std::sin(q(2));

  // the order must not matter, so I shuffle it
  std::array<int, 4> order{0, 1, 2, 3};
  std::mt19937 random(1234);
  std::shuffle(order.begin(), order.end(), random);

  bool first = true;
  double phi = 0;
  double r_x = 0;
  double r_y = 0;
  for (int k : order) {
    const double a = (k & 1) ? -half : half;
    const double b = (k & 2) ? -half : half;
    const double x = c * a - s * b;
    const double y = s * a + c * b;
    if (first || q(1) + y < phi) {
      phi = q(1) + y;
      r_x = x;
      r_y = y;
      first = false;
    }
  }

  Jacobian J;
  J << 1, 0,
       0, 1,
       -r_y, r_x;
  return {J, phi};
}

}  // namespace bounce
