#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const Contact contact = get_contacts(q, params);
  const Vector3 J_t = contact.J.col(0), J_n = contact.J.col(1);
  const Eigen::Matrix3d M_inv = params.M().inverse();
  const Vector3 f_e = params.M() * params.g;
  const double gap = contact.phi - params.delta;

  if (gap < params.delta) {
    const Lcp lcp = form_lcp(contact.J, v, params);
    const Vector3 f = solve_lcp(lcp.V, lcp.p);
    const Vector3 v_new = v + params.dt * M_inv * (f_e + J_n * f(0) - J_t * f(1) + J_t * f(2));
    const Vector3 q_new = q + params.dt * v_new + Vector3(0, params.delta, 0);
    return {q_new, v_new};
  }
  const Vector3 v_new = v + params.dt * M_inv * f_e;
  const Vector3 q_new = q + params.dt * v_new;
  return {q_new, v_new};
}

}  // namespace bounce
