#include <bounce/part1_contacts.hpp>
#include <cmath>

namespace bounce {

Contact get_contacts(const Vector3& q, const Parameters& params) {
  Eigen::Matrix2d R;
  R << std::cos(q(2)), -std::sin(q(2)), std::sin(q(2)), std::cos(q(2));
  Eigen::Vector2d r = Eigen::Vector2d::Zero();
  for (double i : {-0.5, 0.5}) {
    for (double j : {-0.5, 0.5}) {
      const Eigen::Vector2d arm = R * Eigen::Vector2d(i * params.l, j * params.l);
      if (arm(1) < r(1)) r = arm;
    }
  }
  Jacobian J;
  J << 1, 0, 0, 1, -r(1), r(0);
  return {J, q(1) + r(1)};
}

}  // namespace bounce
