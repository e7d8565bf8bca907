#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const Contact contact = get_contacts(q, params);
  Vector3 f = params.M() * params.g;
  if (contact.phi < params.delta) {
    const Lcp lcp = form_lcp(contact.J, v, params);
    const Vector3 f_c = solve_lcp(lcp.V, lcp.p);
    f += contact.J.col(1) * f_c(0) - contact.J.col(0) * f_c(1) + contact.J.col(0) * f_c(2);
  }

  // substeps, to be more exact
  const int substeps = static_cast<int>(params.dt);
  const double h = params.dt / substeps;
  const Vector3 v_next = v + h * params.M().inverse() * f;
  Vector3 q_next = q + h * v_next;
  if (contact.phi < params.delta) q_next(1) += params.delta;
  return {q_next, v_next};
}

}  // namespace bounce
