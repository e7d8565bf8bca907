#include <bounce/part1_contacts.hpp>

namespace bounce {

Contact get_contacts(const Vector3& q, const Parameters& params) {
  Eigen::Matrix<double, 2, 4> corners;
  corners << 1, -1, -1, 1,
             1, 1, -1, -1;
  corners *= params.l / 2;
  const auto turned = Eigen::Rotation2Dd(q(2)).toRotationMatrix() * corners;

  int lowest = 0;
  for (int k = 1; k < 4; ++k) {
    if (turned(1, k) < turned(1, lowest)) lowest = k;
  }
  const double rx = turned(0, lowest), ry = turned(1, lowest);

  Contact contact;
  contact.J << 1, 0,
               0, 1,
               -ry, rx;
  contact.phi = q(1) + ry;
  return contact;
}

}  // namespace bounce
