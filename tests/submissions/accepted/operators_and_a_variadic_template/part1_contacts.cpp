#include <bounce/part1_contacts.hpp>
#include <cmath>

namespace bounce {

namespace {

template <typename Scalar>
struct Vec2 {
  Scalar x{};
  Scalar y{};
  friend constexpr Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
  friend constexpr Vec2 operator-(Vec2 a) { return {-a.x, -a.y}; }
  friend constexpr Vec2 operator*(Scalar k, Vec2 a) { return {k * a.x, k * a.y}; }
  friend constexpr bool operator<(Vec2 a, Vec2 b) { return a.y < b.y; }
};

template <typename T>
constexpr T lowest(T a) {
  return a;
}

template <typename T, typename... Rest>
constexpr T lowest(T a, Rest... rest) {
  const T b = lowest(rest...);
  return b < a ? b : a;
}

}  // namespace

Contact get_contacts(const Vector3& q, const Parameters& params) {
  using Vec = Vec2<double>;
  // the axes of the body, half a side long
  const Vec a = params.l / 2 * Vec{std::cos(q(2)), std::sin(q(2))};
  const Vec b{-a.y, a.x};
  const Vec r = lowest(a + b, -a + b, -a + -b, a + -b);

  Jacobian J;
  J << 1.0, 0.0, 0.0, 1.0, -r.y, r.x;
  return {J, q(1) + r.y};
}

}  // namespace bounce
