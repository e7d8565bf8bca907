#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const Eigen::Matrix3d M = params.M();
  Vector3 f = M * params.g;
  Vector3 q_next = q;

  const Contact contact = get_contacts(q, params);
  if (contact.phi < params.delta) {
    const Lcp lcp = form_lcp(contact.J, v, params);
    const Vector3 f_c = solve_lcp(lcp.V, lcp.p);
    f += contact.J.col(1) * f_c(0) + contact.J.col(0) * (f_c(2) - f_c(1));
    q_next(1) += params.delta;
  }

  const Vector3 v_next = v + M.inverse() * f;
  q_next += params.dt * v_next;
  return {q_next, v_next};
}

}  // namespace bounce
