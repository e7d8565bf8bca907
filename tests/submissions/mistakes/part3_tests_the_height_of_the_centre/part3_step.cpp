#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const bool contact = q(1) < params.delta;
  Vector3 f = params.M() * params.g;
  if (contact) {
    const Jacobian J = get_contacts(q, params).J;
    const Lcp lcp = form_lcp(J, v, params);
    const Vector3 f_c = solve_lcp(lcp.V, lcp.p);
    f += J.col(1) * f_c(0) - J.col(0) * f_c(1) + J.col(0) * f_c(2);
  }
  const Vector3 v_next = v + params.dt * params.M().inverse() * f;
  const Vector3 q_next = q + params.dt * v_next + Vector3(0, contact ? params.delta : 0.0, 0);
  return {q_next, v_next};
}

}  // namespace bounce
