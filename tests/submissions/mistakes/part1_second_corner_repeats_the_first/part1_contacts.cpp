#include <bounce/part1_contacts.hpp>
#include <Eigen/Geometry>
#include <vector>

namespace bounce {

Contact get_contacts(const Vector3& q, const Parameters& params) {
  const double l = params.l;
  const std::vector<Eigen::Vector2d> s = {
      {l / 2, l / 2},
      {l / 2, l / 2},
      {-l / 2, -l / 2},
      {l / 2, -l / 2},
  };
  const Eigen::Matrix2d R = Eigen::Rotation2Dd(q(2)).toRotationMatrix();

  Eigen::Vector2d r = R * s[0];
  for (const Eigen::Vector2d& s_k : s) {
    const Eigen::Vector2d r_k = R * s_k;
    if (r_k.y() < r.y()) r = r_k;
  }

  Contact contact;
  contact.phi = q(1) + r.y();
  contact.J << Vector3(1, 0, -r.y()), Vector3(0, 1, r.x());
  return contact;
}

}  // namespace bounce
