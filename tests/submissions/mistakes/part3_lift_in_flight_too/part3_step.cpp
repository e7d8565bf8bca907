#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>

namespace bounce {

namespace {

Vector3 contact_force(const Vector3& q, const Vector3& v, const Parameters& params) {
  const Contact contact = get_contacts(q, params);
  if (contact.phi >= params.delta) return Vector3::Zero();
  const Lcp lcp = form_lcp(contact.J, v, params);
  const Vector3 f = solve_lcp(lcp.V, lcp.p);
  return contact.J * Eigen::Vector2d(f(2) - f(1), f(0));
}

}  // namespace

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const Vector3 f = params.M() * params.g + contact_force(q, v, params);
  State next;
  next.v = v + params.dt * params.M().inverse() * f;
  next.q = q + params.dt * next.v + Vector3(0, params.delta, 0);
  return next;
}

}  // namespace bounce
