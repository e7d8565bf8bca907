#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>

#define DT 0.01

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  Contact contact = get_contacts(q, params);
  Vector3 f_e = params.M() * params.g;
  Vector3 v_n, q_n;
  if (contact.phi < params.delta) {
    Lcp lcp = form_lcp(contact.J, v, params);
    Vector3 f = solve_lcp(lcp.V, lcp.p);
    v_n = v + DT * params.M().inverse() * (f_e + contact.J.col(1) * f(0) - contact.J.col(0) * f(1) + contact.J.col(0) * f(2));
    q_n = q + DT * v_n + Vector3(0, params.delta, 0);
  } else {
    v_n = v + DT * params.M().inverse() * f_e;
    q_n = q + DT * v_n;
  }
  return {q_n, v_n};
}

}  // namespace bounce
