#include <bounce/part1_contacts.hpp>
#include <cmath>
#include <vector>

using namespace Eigen;

namespace bounce {

Contact get_contacts(const Vector3& q, const Parameters& params) {
  // rotation matrix
  MatrixXd R(2, 2);
  R << cos(q(2)), -sin(q(2)),
       sin(q(2)),  cos(q(2));

  double a = params.l / 2;
  std::vector<VectorXd> corners;
  for (double sx : {a, -a}) {
    for (double sy : {a, -a}) {
      VectorXd s(2);
      s << sx, sy;
      corners.push_back(R * s + q.head(2));
    }
  }

  // find the lowest corner
  size_t index = 0;
  for (size_t i = 0; i < corners.size(); i++) {
    if (corners[i](1) < corners[index](1)) index = i;
  }
  VectorXd r = corners[index] - q.head(2);

  Contact contact;
  contact.J = MatrixXd::Zero(3, 2);
  contact.J(0, 0) = 1;
  contact.J(2, 0) = -r(1);
  contact.J(1, 1) = 1;
  contact.J(2, 1) = r(0);
  contact.phi = corners[index](1);
  return contact;
}

}  // namespace bounce
