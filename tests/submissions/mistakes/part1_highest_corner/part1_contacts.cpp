#include <bounce/part1_contacts.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace bounce {

Contact get_contacts(const Vector3& q, const Parameters& params) {
  std::array<Eigen::Vector2d, 4> corners;
  for (int k = 0; k < 4; ++k) {
    const double angle = q(2) + M_PI / 4 + k * M_PI / 2;
    corners[k] = params.l / std::sqrt(2) * Eigen::Vector2d(std::cos(angle), std::sin(angle));
  }
  std::sort(corners.begin(), corners.end(),
            [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.y() > b.y(); });
  const Eigen::Vector2d& r = corners.front();

  Jacobian J;
  J << 1, 0,
       0, 1,
       -r.y(), r.x();
  return {J, q(1) + r.y()};
}

}  // namespace bounce
