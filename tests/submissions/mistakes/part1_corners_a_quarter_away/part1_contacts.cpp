#include <bounce/part1_contacts.hpp>
#include <cmath>

namespace bounce {

namespace {

// half the side
double half(const Parameters& params) { return params.l / 2; }

Eigen::Vector2d corner(int i, int j, const Vector3& q, const Parameters& params) {
  const Eigen::Vector2d s(i * half(params) / 2, j * half(params) / 2);
  return {std::cos(q(2)) * s(0) - std::sin(q(2)) * s(1), std::sin(q(2)) * s(0) + std::cos(q(2)) * s(1)};
}

}  // namespace

Contact get_contacts(const Vector3& q, const Parameters& params) {
  Eigen::Vector2d r = corner(1, 1, q, params);
  for (int i : {-1, 1}) {
    for (int j : {-1, 1}) {
      const Eigen::Vector2d candidate = corner(i, j, q, params);
      if (candidate.y() < r.y()) r = candidate;
    }
  }
  Contact contact;
  contact.J << 1, 0, 0, 1, -r.y(), r.x();
  contact.phi = q(1) + r.y();
  return contact;
}

}  // namespace bounce
