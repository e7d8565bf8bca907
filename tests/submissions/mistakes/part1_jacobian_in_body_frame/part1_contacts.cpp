#include <Eigen/Geometry>
#include <limits>
#include <bounce/part1_contacts.hpp>

namespace bounce {

Contact get_contacts(const Vector3& q, const Parameters& params) {
  const double h = params.l / 2;
  const Eigen::Rotation2Dd rotation(q(2));
  double phi = std::numeric_limits<double>::infinity();
  Eigen::Vector2d r = Eigen::Vector2d::Zero();

  for (double sx : {-h, h}) {
    for (double sy : {-h, h}) {
      const Eigen::Vector2d s(sx, sy);
      const double height = q(1) + (rotation * s).y();
      if (height < phi) {
        phi = height;
        r = s;
      }
    }
  }

  Jacobian J;
  J << 1.0, 0.0,
       0.0, 1.0,
       -r.y(), r.x();
  return {J, phi};
}

}  // namespace bounce
