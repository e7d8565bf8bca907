#include <bounce/part1_contacts.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace bounce {

struct Corner {
  double x, y;  // world frame
  bool operator<(const Corner& other) const { return y < other.y; }
};

Contact get_contacts(const Vector3& q, const Parameters& params) {
  std::vector<Corner> corners;
  for (int i = 0; i < 4; ++i) {
    const double s_x = (i == 0 || i == 3 ? 0.5 : -0.5) * params.l;
    const double s_y = (i < 2 ? 0.5 : -0.5) * params.l;
    corners.push_back({q(0) + std::cos(q(2)) * s_x - std::sin(q(2)) * s_y,
                       q(1) + std::sin(q(2)) * s_x + std::cos(q(2)) * s_y});
  }
  std::sort(corners.begin(), corners.end());

  const Corner lowest = corners.front();
  const double r_x = lowest.x - q(0);
  const double r_y = lowest.y - q(1);

  Contact result;
  result.phi = lowest.y;
  result.J << 1, 0,
              0, 1,
              -r_y, r_x;
  return result;
}

}  // namespace bounce
