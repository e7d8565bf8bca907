#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const Contact contact = get_contacts(q, params);
  const bool touching = contact.phi < params.delta;

  Vector3 a = params.g;
  if (touching) {
    const Lcp lcp = form_lcp(contact.J, v, params);
    const Vector3 f = solve_lcp(lcp.V, lcp.p);
    a += (contact.J.col(1) * f(0) - contact.J.col(0) * f(1) + contact.J.col(0) * f(2)) / params.m;
  }

  const Vector3 v_next = v + params.dt * a;
  Vector3 q_next = q + params.dt * v_next;
  if (touching) q_next(1) += params.delta;
  return {q_next, v_next};
}

}  // namespace bounce
