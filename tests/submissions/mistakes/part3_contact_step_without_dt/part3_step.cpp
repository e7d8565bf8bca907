#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const Contact contact = get_contacts(q, params);
  const Vector3 J_t = contact.J.col(0);
  const Vector3 J_n = contact.J.col(1);
  const Eigen::Matrix3d M = params.M();
  const Eigen::Matrix3d M_inv = M.inverse();
  const Vector3 f_e = M * params.g;

  Vector3 v_next = v + params.dt * M_inv * f_e;
  Vector3 q_next = q + params.dt * v_next;
  if (contact.phi < params.delta) {
    const Lcp lcp = form_lcp(contact.J, v, params);
    const Vector3 f = solve_lcp(lcp.V, lcp.p);
    v_next = v + M_inv * (f_e + J_n * f(0) - J_t * f(1) + J_t * f(2));
    q_next = q + params.dt * v_next + Vector3(0, params.delta, 0);
  }
  return {q_next, v_next};
}

}  // namespace bounce
