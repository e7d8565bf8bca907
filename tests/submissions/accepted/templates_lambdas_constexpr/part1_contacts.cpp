#include <array>
#include <bounce/part1_contacts.hpp>
#include <cmath>
#include <utility>

namespace bounce {
namespace {

constexpr std::array<std::pair<int, int>, 4> kCorners = {{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};

template <typename T>
concept Real = std::floating_point<T>;

template <Real T>
constexpr T square(T x) {
  return x * x;
}

static_assert(square(0.5) == 0.25);

template <std::size_t... I>
Eigen::Vector2d lowest(const auto& arm, std::index_sequence<I...>) {
  Eigen::Vector2d best = arm(0);
  ((best = arm(I).y() < best.y() ? arm(I) : best), ...);
  return best;
}

}  // namespace

Contact get_contacts(const Vector3& q, const Parameters& params) {
  const auto arm = [c = std::cos(q.z()), s = std::sin(q.z()), h = params.l / 2](std::size_t k) -> Eigen::Vector2d {
    const auto [i, j] = kCorners[k];
    return {h * (c * i - s * j), h * (s * i + c * j)};
  };
  const Eigen::Vector2d r = lowest(arm, std::make_index_sequence<kCorners.size()>{});
  return {.J = (Jacobian() << 1, 0, 0, 1, -r.y(), r.x()).finished(), .phi = q.y() + r.y()};
}

}  // namespace bounce
