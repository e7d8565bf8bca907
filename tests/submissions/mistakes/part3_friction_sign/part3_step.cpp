#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const Contact contact = get_contacts(q, params);
  const Vector3 J_t = contact.J.col(0);
  const Vector3 J_n = contact.J.col(1);
  const Vector3 f_e = params.M() * params.g;
  const Eigen::Matrix3d M_inv = params.M().inverse();

  Vector3 v_new, q_new;
  if (contact.phi < params.delta) {
    const Lcp lcp = form_lcp(contact.J, v, params);
    const Vector3 f_c = solve_lcp(lcp.V, lcp.p);
    const double f_n = f_c(0);
    const double f_t1 = f_c(1);
    const double f_t2 = f_c(2);
    v_new = v + params.dt * M_inv * (f_e + J_n * f_n + J_t * f_t1 - J_t * f_t2);
    q_new = q + params.dt * v_new + Vector3(0, params.delta, 0);
  } else {
    v_new = v + params.dt * M_inv * f_e;
    q_new = q + params.dt * v_new;
  }
  return {q_new, v_new};
}

}  // namespace bounce
