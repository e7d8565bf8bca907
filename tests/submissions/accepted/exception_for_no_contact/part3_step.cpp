#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>
#include <stdexcept>

namespace bounce {

namespace {

struct NoContact : std::runtime_error {
  NoContact() : std::runtime_error("the square is in the air") {}
};

Contact touching(const Vector3& q, const Parameters& params) {
  const Contact contact = get_contacts(q, params);
  if (contact.phi >= params.delta) throw NoContact();
  return contact;
}

State hit(const Vector3& q, const Vector3& v, const Contact& contact, const Parameters& params) {
  const Lcp lcp = form_lcp(contact.J, v, params);
  const Vector3 f = solve_lcp(lcp.V, lcp.p);
  const Vector3 ground = contact.J.col(1) * f(0) - contact.J.col(0) * f(1) + contact.J.col(0) * f(2);
  const Vector3 next = v + params.dt * (params.g + params.M().inverse() * ground);
  return {q + params.dt * next + Vector3(0, params.delta, 0), next};
}

State fly(const Vector3& q, const Vector3& v, const Parameters& params) {
  const Vector3 next = v + params.dt * params.g;
  return {q + params.dt * next, next};
}

}  // namespace

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  try {
    return hit(q, v, touching(q, params), params);
  } catch (const NoContact&) {
    return fly(q, v, params);
  }
}

}  // namespace bounce
