#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const Eigen::Matrix3d M_inv = params.M().inverse();
  const Vector3 f_e = params.g;

  const Contact contact = get_contacts(q, params);
  if (contact.phi >= params.delta) {
    const Vector3 v_next = v + params.dt * M_inv * f_e;
    return {q + params.dt * v_next, v_next};
  }

  const Lcp lcp = form_lcp(contact.J, v, params);
  const Vector3 f = solve_lcp(lcp.V, lcp.p);
  const Vector3 f_c = contact.J.col(1) * f(0) - contact.J.col(0) * f(1) + contact.J.col(0) * f(2);
  const Vector3 v_next = v + params.dt * M_inv * (f_e + f_c);
  return {q + params.dt * v_next + Vector3(0, params.delta, 0), v_next};
}

}  // namespace bounce
