#include <bounce/part1_contacts.hpp>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <ranges>

namespace bounce {

auto get_contacts(const Vector3& q, const Parameters& params) -> Contact {
  const auto radius = params.l / std::numbers::sqrt2;
  const auto arm = [&](int k) {
    const auto angle = q.z() + (2 * k + 1) * std::numbers::pi / 4;
    return Eigen::Vector2d{radius * std::cos(angle), radius * std::sin(angle)};
  };
  const auto height = [&](int k) { return arm(k).y(); };
  const auto r = arm(*std::ranges::min_element(std::views::iota(0, 4), {}, height));

  auto J = Jacobian{Jacobian::Identity()};
  J(2, 0) = -r.y();
  J(2, 1) = r.x();
  return {.J = J, .phi = q.y() + r.y()};
}

}  // namespace bounce
