#include <bounce/part1_contacts.hpp>
#include <cmath>

namespace bounce {

Contact get_contacts(const Vector3& q, const Parameters& params) {
  const double half = 1 / 2 * params.l;

  Eigen::Matrix<double, 2, 4> s;
  s << half, half, -half, -half,
       half, -half, half, -half;

  Eigen::Matrix2d R;
  R << std::cos(q(2)), -std::sin(q(2)),
       std::sin(q(2)), std::cos(q(2));

  const Eigen::Matrix<double, 2, 4> r = R * s;
  int k = 0;
  for (int i = 0; i < 4; ++i) {
    if (r(1, i) < r(1, k)) k = i;
  }

  Jacobian J;
  J << 1, 0, 0, 1, -r(1, k), r(0, k);
  return {J, q(1) + r(1, k)};
}

}  // namespace bounce
