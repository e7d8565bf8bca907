#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const Contact contact = get_contacts(q, params);
  Vector3 f = params.m * params.g;
  if (contact.phi < params.delta) {
    const Lcp lcp = form_lcp(contact.J, v, params);
    const Vector3 f_c = solve_lcp(lcp.V, lcp.p);
    f += contact.J.col(1) * f_c(0) - contact.J.col(0) * f_c(1) + contact.J.col(0) * f_c(2);
  }

  const double I = params.m * params.l * params.l / 6;
  const Vector3 a(f(0) / params.m, f(1) / params.m, f(2) / I);
  State next;
  next.v = v + params.dt * a;
  next.q = q + params.dt * next.v;
  if (contact.phi < params.delta) next.q += Vector3(0, params.delta, 0);
  return next;
}

}  // namespace bounce
