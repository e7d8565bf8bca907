#include <bounce/part1_contacts.hpp>
#include <cmath>
#include <numbers>

namespace bounce {

namespace {

Contact compute(const Vector3& q, const Parameters& params) {
  // corner k lies on a circle, 45 degrees plus k quarter turns from the body's x axis
  const double radius = params.l / std::numbers::sqrt2;
  double best = q(2) + std::numbers::pi / 4;
  for (int k = 1; k < 4; ++k) {
    const double angle = q(2) + std::numbers::pi / 4 + k * std::numbers::pi / 2;
    if (std::sin(angle) < std::sin(best)) best = angle;
  }
  const double rx = radius * std::cos(best);
  const double ry = radius * std::sin(best);

  Contact contact;
  contact.J << 1, 0,
               0, 1,
               -ry, rx;
  contact.phi = q(1) + ry;
  return contact;
}

}  // namespace

// step asks for the same configuration again when I test, so the last answer is kept
Contact get_contacts(const Vector3& q, const Parameters& params) {
  thread_local Vector3 last_q = Vector3::Constant(NAN);
  thread_local double last_l = NAN;
  thread_local Contact last;
  if (!(q == last_q && params.l == last_l)) {
    last = compute(q, params);
    last_q = q;
    last_l = params.l;
  }
  return last;
}

}  // namespace bounce
