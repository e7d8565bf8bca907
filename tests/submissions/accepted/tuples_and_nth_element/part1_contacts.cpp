#include <bounce/part1_contacts.hpp>
#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

namespace bounce {

auto get_contacts(const Vector3& q, const Parameters& params) -> Contact {
  const auto h = params.l / 2;
  const auto [c, s] = std::pair{h * std::cos(q.z()), h * std::sin(q.z())};

  auto arms = std::vector<std::tuple<double, double>>{  // (r_y, r_x), to be sorted by height
      {s + c, c - s}, {c - s, -c - s}, {-s - c, s - c}, {s - c, c + s}};
  std::nth_element(arms.begin(), arms.begin(), arms.end());
  const auto [ry, rx] = arms.front();

  auto J = Jacobian{};
  J.col(0) = Vector3{1, 0, -ry};
  J.col(1) = Vector3{0, 1, rx};
  return {J, q.y() + ry};
}

}  // namespace bounce
