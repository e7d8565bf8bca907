#include <bounce/part1_contacts.hpp>

#include "helpers/rotation.hpp"

namespace bounce {

Contact get_contacts(const Vector3& q, const Parameters& params) {
  Eigen::Matrix<double, 2, 4> s;
  s << 1, 1, -1, -1, 1, -1, 1, -1;
  const Eigen::Matrix<double, 2, 4> r = helpers::rotation(q(2)) * s * params.l / 2;

  int k;
  const double depth = r.row(1).minCoeff(&k);
  Jacobian J;
  J << 1, 0, 0, 1, -r(1, k), r(0, k);
  return {J, q(1) + depth};
}

}  // namespace bounce
