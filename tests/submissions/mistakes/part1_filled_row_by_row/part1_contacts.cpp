#include <algorithm>
#include <bounce/part1_contacts.hpp>
#include <cmath>

namespace bounce {

Contact get_contacts(const Vector3& q, const Parameters& params) {
  const double c = std::cos(q(2)) * params.l / 2;
  const double s = std::sin(q(2)) * params.l / 2;
  const double rx[] = {c - s, -c - s, -c + s, c + s};
  const double ry[] = {s + c, -s + c, -s - c, s - c};
  const auto k = std::min_element(ry, ry + 4) - ry;

  Jacobian J;
  // the tangential one, then the normal one
  J << 1, 0, -ry[k], 0, 1, rx[k];
  return {J, q(1) + ry[k]};
}

}  // namespace bounce
