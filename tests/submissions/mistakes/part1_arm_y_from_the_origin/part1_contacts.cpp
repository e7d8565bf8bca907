#include <bounce/part1_contacts.hpp>
#include <Eigen/Geometry>

namespace bounce {

Contact get_contacts(const Vector3& q, const Parameters& params) {
  const Eigen::Rotation2Dd R(q(2));
  const Eigen::Vector2d centre(q(0), q(1));
  const double half = params.l / 2;

  Eigen::Vector2d lowest = centre + R * Eigen::Vector2d(half, half);
  for (const Eigen::Vector2d& s : {Eigen::Vector2d(-half, half), Eigen::Vector2d(-half, -half),
                                   Eigen::Vector2d(half, -half)}) {
    const Eigen::Vector2d corner = centre + R * s;
    if (corner(1) < lowest(1)) lowest = corner;
  }

  Contact contact;
  contact.phi = lowest(1);
  contact.J.col(0) = Vector3(1, 0, -lowest(1));
  contact.J.col(1) = Vector3(0, 1, lowest(0) - q(0));
  return contact;
}

}  // namespace bounce
