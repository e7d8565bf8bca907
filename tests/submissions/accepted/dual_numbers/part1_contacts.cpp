#include <bounce/part1_contacts.hpp>
#include <array>
#include <cmath>

namespace bounce {
namespace {

// A number with its derivatives by x, y and theta.
struct Dual {
  double value = 0;
  Vector3 slope = Vector3::Zero();
};
Dual operator+(const Dual& a, const Dual& b) { return {a.value + b.value, a.slope + b.slope}; }
Dual operator-(const Dual& a, const Dual& b) { return {a.value - b.value, a.slope - b.slope}; }
Dual operator*(double s, const Dual& a) { return {s * a.value, s * a.slope}; }
Dual sin(const Dual& a) { return {std::sin(a.value), std::cos(a.value) * a.slope}; }
Dual cos(const Dual& a) { return {std::cos(a.value), -std::sin(a.value) * a.slope}; }

struct Point {
  Dual x, y;
};

}  // namespace

// J_t and J_n are how the corner moves with q, so they are derivatives.
Contact get_contacts(const Vector3& q, const Parameters& params) {
  std::array<Dual, 3> u;
  for (int i = 0; i < 3; ++i) u[i] = {q(i), Vector3::Unit(i)};
  const Dual c = cos(u[2]), s = sin(u[2]);

  Point lowest;
  bool first = true;
  for (int k = 0; k < 4; ++k) {
    const double a = (k & 1 ? 1 : -1) * params.l / 2, b = (k & 2 ? 1 : -1) * params.l / 2;
    const Point corner{u[0] + (a * c - b * s), u[1] + (a * s + b * c)};
    if (first || corner.y.value < lowest.y.value) lowest = corner;
    first = false;
  }

  Jacobian J;
  J << lowest.x.slope, lowest.y.slope;
  return {J, lowest.y.value};
}

}  // namespace bounce
