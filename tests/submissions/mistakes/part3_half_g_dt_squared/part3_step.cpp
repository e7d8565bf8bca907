#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const double dt = params.dt;
  const Contact contact = get_contacts(q, params);
  Vector3 f = params.M() * params.g;
  if (contact.phi < params.delta) {
    const Lcp lcp = form_lcp(contact.J, v, params);
    const Vector3 f_c = solve_lcp(lcp.V, lcp.p);
    f += contact.J.col(1) * f_c(0) + contact.J.col(0) * (f_c(2) - f_c(1));
  }

  // uniformly accelerated motion during dt
  const Vector3 a = params.M().inverse() * f;
  State next;
  next.v = v + a * dt;
  next.q = q + v * dt + 0.5 * a * dt * dt;
  if (contact.phi < params.delta) next.q(1) += params.delta;
  return next;
}

}  // namespace bounce
