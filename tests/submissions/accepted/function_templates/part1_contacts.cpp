#include <bounce/part1_contacts.hpp>
#include <cmath>

namespace bounce {

namespace {

template <typename Scalar>
struct Point {
  Scalar x;
  Scalar y;
};

template <typename Scalar>
Point<Scalar> rotate(Point<Scalar> p, Scalar angle) {
  const Scalar c = std::cos(angle);
  const Scalar s = std::sin(angle);
  return {c * p.x - s * p.y, s * p.x + c * p.y};
}

template <typename Scalar, int N>
Point<Scalar> lowest(const Point<Scalar> (&points)[N]) {
  Point<Scalar> best = points[0];
  for (int k = 1; k < N; ++k) {
    if (points[k].y < best.y) best = points[k];
  }
  return best;
}

}  // namespace

Contact get_contacts(const Vector3& q, const Parameters& params) {
  const double h = params.l / 2;
  const Point<double> arms[4] = {
      rotate(Point<double>{h, h}, q(2)),
      rotate(Point<double>{-h, h}, q(2)),
      rotate(Point<double>{-h, -h}, q(2)),
      rotate(Point<double>{h, -h}, q(2)),
  };
  const Point<double> r = lowest(arms);

  Jacobian J;
  J << 1.0, 0.0, 0.0, 1.0, -r.y, r.x;
  return {J, q(1) + r.y};
}

}  // namespace bounce
