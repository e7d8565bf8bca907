#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const Contact contact = get_contacts(q, params);
  const Eigen::Matrix3d M_inv = params.M().inverse();
  const Vector3 f_e = params.M() * params.g;

  Vector3 v_new = v + params.dt * M_inv * f_e;
  if (contact.phi >= params.delta) {
    return {q + params.dt * v_new, v_new};
  }

  const Lcp lcp = form_lcp(contact.J, v, params);
  const Vector3 P = solve_lcp(lcp.V, lcp.p);  // impulses
  v_new += M_inv * (contact.J.col(1) * P(0) + contact.J.col(0) * (P(2) - P(1)));
  return {q + params.dt * v_new + Vector3(0, params.delta, 0), v_new};
}

}  // namespace bounce
