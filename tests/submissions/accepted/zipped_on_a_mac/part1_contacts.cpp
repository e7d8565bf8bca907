#include <bounce/part1_contacts.hpp>
#include <cmath>

namespace bounce {

Contact get_contacts(const Vector3& q, const Parameters& params) {
  const double c = std::cos(q(2)) * params.l / 2;
  const double s = std::sin(q(2)) * params.l / 2;
  const double r_y[4] = {s + c, s - c, -s - c, -s + c};
  const double r_x[4] = {c - s, c + s, -c + s, -c - s};
  int k = 0;
  for (int i = 1; i < 4; ++i) k = r_y[i] < r_y[k] ? i : k;
  return {(Jacobian() << 1, 0, 0, 1, -r_y[k], r_x[k]).finished(), q(1) + r_y[k]};
}

}  // namespace bounce
