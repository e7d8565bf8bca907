#include <bounce/part1_contacts.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace bounce {

auto get_contacts(const Vector3& q, const Parameters& params) -> Contact {
  constexpr auto signs = std::to_array<std::pair<double, double>>({{1, 1}, {-1, 1}, {-1, -1}, {1, -1}});
  const auto h = params.l / 2;
  const auto c = std::cos(q.z());
  const auto s = std::sin(q.z());

  auto arms = std::array<Eigen::Vector2d, 4>{};
  std::ranges::transform(signs, arms.begin(), [=](const auto& sign) {
    const auto [a, b] = sign;
    return Eigen::Vector2d{h * (c * a - s * b), h * (s * a + c * b)};
  });
  const auto lowest = std::ranges::min_element(arms, {}, [](const auto& r) { return r.y(); });
  const auto rx = lowest->x();
  const auto ry = lowest->y();

  auto J = Jacobian{Jacobian::Identity()};
  J(2, 0) = -ry;
  J(2, 1) = rx;
  return {.J = J, .phi = q.y() + ry};
}

}  // namespace bounce
