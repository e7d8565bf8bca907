#include <bounce/part1_contacts.hpp>
#include <algorithm>
#include <cmath>
#include <vector>

namespace bounce {

Contact get_contacts(const Vector3& q, const Parameters& params) {
  const double d = params.l / 2;
  const double c = std::cos(q[2]);
  const double s = std::sin(q[2]);
  std::vector<Eigen::Vector2d> r = {
      {c * d - s * d, s * d + c * d},
      {c * d + s * d, s * d - c * d},
      {-c * d - s * d, -s * d + c * d},
      {-c * d + s * d, -s * d - c * d},
  };
  const auto low = *std::min_element(r.begin(), r.end(), [](const auto& a, const auto& b) { return a.y() < b.y(); });

  Vector3 normal{0, 1, low.x()};
  Vector3 tangent{1, 0, -low.y()};

  Jacobian J;
  J << normal, tangent;
  return {J, q[1] + low.y()};
}

}  // namespace bounce
