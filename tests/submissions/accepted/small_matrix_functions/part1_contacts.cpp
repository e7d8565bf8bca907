#include <bounce/part1_contacts.hpp>

namespace bounce {

Contact get_contacts(const Vector3& q, const Parameters& params) {
  // one corner per column, body frame
  Eigen::Matrix<double, 2, 4> S;
  S << 1, -1, -1, 1,
       1, 1, -1, -1;
  S *= params.l / 2;

  const Eigen::Matrix2d R = Eigen::Rotation2Dd(q.z()).toRotationMatrix();
  const Eigen::Matrix<double, 2, 4> r = R * S;

  Eigen::Index k;
  const double lowest = r.row(1).minCoeff(&k);

  Contact contact;
  contact.J.setIdentity();
  contact.J.row(2) << -r(1, k), r(0, k);
  contact.phi = q.y() + lowest;
  return contact;
}

}  // namespace bounce
