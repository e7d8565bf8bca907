#include <bounce/part1_contacts.hpp>
#include <cmath>

namespace bounce {

Contact get_contacts(const Vector3& q, const Parameters& params) {
  const double h = params.l / 2;
  const double theta = q(2);

  const auto arm = [h, theta](int sx, int sy) {
    return Eigen::Vector2d(h * (sx * std::cos(theta) - sy * std::sin(theta)),
                           h * (sx * std::sin(theta) + sy * std::cos(theta)));
  };
  const auto lower = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.y() < b.y() ? a : b;
  };
  const auto jacobian = [](const Eigen::Vector2d& r) {
    Jacobian J;
    J << 1, 0, 0, 1, -r.y(), r.x();
    return J;
  };

  const Eigen::Vector2d r = lower(lower(arm(1, 1), arm(-1, 1)), lower(arm(-1, -1), arm(1, -1)));
  return {jacobian(r), q(1) + r.y()};
}

}  // namespace bounce
