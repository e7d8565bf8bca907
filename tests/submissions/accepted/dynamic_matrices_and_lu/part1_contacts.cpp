#include <bounce/part1_contacts.hpp>
#include <cmath>

namespace bounce {

Contact get_contacts(const Vector3& q, const Parameters& params) {
  Eigen::MatrixXd R(2, 2), corners(2, 4);
  R << cos(q(2)), -sin(q(2)), sin(q(2)), cos(q(2));
  corners << 1, -1, -1, 1, 1, 1, -1, -1;
  corners *= params.l / 2;
  Eigen::MatrixXd world = R * corners;
  for (Eigen::Index i = 0; i < world.cols(); ++i) world.col(i) += q.head(2);

  Eigen::MatrixXd::Index row, col;
  const double phi = world.bottomRows(1).minCoeff(&row, &col);
  Eigen::VectorXd r = world.col(col) - q.head(2);

  Eigen::MatrixXd J = Eigen::MatrixXd::Zero(3, 2);
  J.topRows(2).setIdentity();
  J(2, 0) = -r(1);
  J(2, 1) = r(0);
  return {J, phi};
}

}  // namespace bounce
