#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const Jacobian J = get_contacts(q, params).J;
  const Lcp lcp = form_lcp(J, v, params);
  const Vector3 f = solve_lcp(lcp.V, lcp.p);  // zero when nothing touches
  const Vector3 f_c = J.col(1) * f(0) - J.col(0) * f(1) + J.col(0) * f(2);
  const Vector3 v_next = v + params.dt * (params.g + params.M().inverse() * f_c);
  const Vector3 q_next = q + params.dt * v_next + Vector3(0, params.delta, 0);
  return {q_next, v_next};
}

}  // namespace bounce
