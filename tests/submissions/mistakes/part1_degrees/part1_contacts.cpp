#include <bounce/part1_contacts.hpp>
#include <cmath>

#define DEG2RAD(a) ((a) * M_PI / 180.0)

namespace bounce {

Contact get_contacts(const Vector3& q, const Parameters& params) {
  const double theta = DEG2RAD(q(2));
  const double w = params.l * 0.5;
  const double offsets[4][2] = {{w, w}, {w, -w}, {-w, w}, {-w, -w}};

  Eigen::Vector2d r(0, 0);
  for (const auto& o : offsets) {
    const double rx = o[0] * std::cos(theta) - o[1] * std::sin(theta);
    const double ry = o[0] * std::sin(theta) + o[1] * std::cos(theta);
    if (ry < r.y()) r << rx, ry;
  }

  Contact ret;
  ret.phi = q(1) + r.y();
  ret.J << 1, 0,
           0, 1,
           -r.y(), r.x();
  return ret;
}

}  // namespace bounce
