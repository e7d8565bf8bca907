#include <bounce/part1_contacts.hpp>
#include <Eigen/Geometry>

namespace bounce {

Contact get_contacts(const Vector3& q, const Parameters& params) {
  Eigen::Isometry2d pose = Eigen::Isometry2d::Identity();
  pose.translate(q.head<2>());
  pose.rotate(q(2));

  Eigen::Matrix<double, 2, 4> body;
  body << 1, -1, -1, 1,
          1, 1, -1, -1;
  body *= params.l / 2;
  const Eigen::Matrix<double, 2, 4> world = pose * body;

  Eigen::Index k;
  const double phi = world.row(1).minCoeff(&k);
  const Eigen::Vector2d r = pose.linear() * body.col(k);

  Contact contact;
  contact.J << 1, 0, 0, 1, -r.y(), r.x();
  contact.phi = phi;
  return contact;
}

}  // namespace bounce
