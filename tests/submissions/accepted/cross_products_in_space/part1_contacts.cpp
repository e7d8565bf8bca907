#include <bounce/part1_contacts.hpp>
#include <Eigen/Geometry>

namespace bounce {

// In space: turns are about z, and the moment of a direction is r x d.
Contact get_contacts(const Vector3& q, const Parameters& params) {
  const Eigen::AngleAxisd turn(q(2), Vector3::UnitZ());
  const Eigen::Quaterniond R(turn);

  Vector3 r(0, params.l, 0);  // above every corner
  for (double a : {-0.5, 0.5})
    for (double b : {-0.5, 0.5}) {
      const Vector3 corner = R * Vector3(a * params.l, b * params.l, 0);
      if (corner.y() < r.y()) r = corner;
    }

  Contact contact;
  for (int k = 0; k < 2; ++k) {
    const Vector3 d = Vector3::Unit(k);
    contact.J.col(k) = d + Vector3(0, 0, r.cross(d).z());
  }
  contact.phi = r.y() + q.y();
  return contact;
}

}  // namespace bounce
