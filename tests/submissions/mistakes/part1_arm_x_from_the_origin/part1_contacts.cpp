#include <bounce/part1_contacts.hpp>

#include <array>
#include <cmath>

namespace bounce {

struct Corner {
  double x;
  double y;
};

Contact get_contacts(const Vector3& q, const Parameters& params) {
  const double a = params.l / 2;
  const double c = cos(q.z());
  const double s = sin(q.z());

  const std::array<Corner, 4> corners = {{
      {q.x() + a * c - a * s, q.y() + a * s + a * c},
      {q.x() - a * c - a * s, q.y() - a * s + a * c},
      {q.x() - a * c + a * s, q.y() - a * s - a * c},
      {q.x() + a * c + a * s, q.y() + a * s - a * c},
  }};

  Corner lowest = corners[0];
  for (const Corner& corner : corners) {
    if (corner.y < lowest.y) lowest = corner;
  }

  Contact result;
  result.J.setZero();
  result.J(0, 0) = 1;
  result.J(2, 0) = q.y() - lowest.y;
  result.J(1, 1) = 1;
  result.J(2, 1) = lowest.x;
  result.phi = lowest.y;
  return result;
}

}  // namespace bounce
