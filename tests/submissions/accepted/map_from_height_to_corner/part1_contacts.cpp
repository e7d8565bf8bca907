#include <bounce/part1_contacts.hpp>
#include <cmath>
#include <map>

using namespace Eigen;

namespace bounce {

Contact get_contacts(const Vector3& q, const Parameters& params) {
  // a map is sorted, so the lowest corner comes first
  std::map<double, Vector2d> corners;
  double a = params.l / 2;
  for (double sx : {a, -a}) {
    for (double sy : {a, -a}) {
      Vector2d r(sx * cos(q(2)) - sy * sin(q(2)), sx * sin(q(2)) + sy * cos(q(2)));
      corners[q(1) + r(1)] = r;
    }
  }
  double height = corners.begin()->first;
  Vector2d r = corners.begin()->second;

  MatrixXd J(3, 2);
  J << 1, 0,
       0, 1,
       -r(1), r(0);
  Contact contact;
  contact.J = J;
  contact.phi = height;
  return contact;
}

}  // namespace bounce
