#include <Eigen/Geometry>
#include <bounce/part1_contacts.hpp>

namespace bounce {

Contact get_contacts(const Vector3& q, const Parameters& params) {
  const Eigen::Rotation2Dd R(q(2));
  const double h = 0.5 * params.l;
  Eigen::Vector2d r = R * Eigen::Vector2d(h, h);
  for (const Eigen::Vector2d& s :
       {Eigen::Vector2d(h, -h), Eigen::Vector2d(-h, h), Eigen::Vector2d(-h, -h)}) {
    const Eigen::Vector2d turned = R * s;
    if (turned(1) < r(1)) r = turned;
  }
  Jacobian J;
  J << 1, 0,
       0, 1,
       -r(0), r(1);
  return {J, q(1) + r(1)};
}

}  // namespace bounce
