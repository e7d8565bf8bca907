#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const double m = 0.3;
  const double I = m * params.l * params.l / 6;
  Vector3 v_next = v + params.dt * params.g;
  Vector3 q_p(0, 0, 0);
  const Contact contact = get_contacts(q, params);
  if (contact.phi < params.delta) {
    const Lcp lcp = form_lcp(contact.J, v, params);
    const Vector3 f = solve_lcp(lcp.V, lcp.p);
    const Vector3 f_c = contact.J.col(1) * f(0) + contact.J.col(0) * (f(2) - f(1));
    v_next += params.dt * Vector3(f_c(0) / m, f_c(1) / m, f_c(2) / I);
    q_p(1) = params.delta;
  }
  return {q + params.dt * v_next + q_p, v_next};
}

}  // namespace bounce
