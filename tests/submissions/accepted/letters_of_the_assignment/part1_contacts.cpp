#include <bounce/part1_contacts.hpp>
#include <cmath>

namespace bounce {

Contact get_contacts(const Vector3& q, const Parameters& params) {
  const double x = q(0), y = q(1), theta = q(2);
  const double l = params.l;
  const Eigen::Vector2d centre(x, y);

  // eq. (3)
  Eigen::Matrix2d R;
  R << std::cos(theta), -std::sin(theta),
       std::sin(theta), std::cos(theta);
  const Eigen::Vector2d s[4] = {
      {l / 2, l / 2}, {-l / 2, l / 2}, {-l / 2, -l / 2}, {l / 2, -l / 2}};
  Eigen::Vector2d c[4];
  for (int k = 0; k < 4; ++k) c[k] = centre + R * s[k];

  // eq. (4)
  int low = 0;
  for (int k = 1; k < 4; ++k) {
    if (c[k](1) < c[low](1)) low = k;
  }
  const double phi = c[low](1);

  // eq. (5)
  const Eigen::Vector2d r = c[low] - centre;

  // eq. (6)
  const Vector3 J_t(1, 0, -r(1));
  const Vector3 J_n(0, 1, r(0));
  Jacobian J;
  J << J_t, J_n;
  return {J, phi};
}

}  // namespace bounce
