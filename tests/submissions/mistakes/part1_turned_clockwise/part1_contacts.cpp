#include <bounce/part1_contacts.hpp>

#include <cmath>

namespace bounce {

static Eigen::Matrix2d rot(double theta) {
  Eigen::Matrix2d R;
  R <<  std::cos(theta), std::sin(theta),
       -std::sin(theta), std::cos(theta);
  return R;
}

Contact get_contacts(const Vector3& q, const Parameters& params) {
  Eigen::MatrixXd s(2, 4);
  s << -1,  1, 1, -1,
       -1, -1, 1,  1;
  s *= params.l / 2.0;

  const Eigen::MatrixXd r = rot(q(2)) * s;

  Eigen::Index idx = 0;
  r.row(1).minCoeff(&idx);

  Contact c;
  c.phi = q(1) + r(1, idx);
  c.J << 1, 0,
         0, 1,
         -r(1, idx), r(0, idx);
  return c;
}

}  // namespace bounce
