#include <bounce/part1_contacts.hpp>
#include <cmath>

namespace bounce {

Contact get_contacts(const Vector3& q, const Parameters& params) {
  Eigen::Matrix<double, 2, 4> C;
  C << -1, 1, 1, -1,
       -1, -1, 1, 1;
  C *= params.l / 2;
  Eigen::Matrix2d R;
  R << std::cos(q(2)), -std::sin(q(2)),
       std::sin(q(2)), std::cos(q(2));
  C = (R * C).eval();

  Eigen::Index k;
  const double phi = C.row(1).minCoeff(&k);

  Jacobian J;
  J.col(0) = Vector3::UnitX() - C(1, k) * Vector3::UnitZ();
  J.col(1) = Vector3::UnitY() + C(0, k) * Vector3::UnitZ();
  return {J, phi};
}

}  // namespace bounce
