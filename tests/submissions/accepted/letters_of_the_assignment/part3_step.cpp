#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const double dt = params.dt, delta = params.delta;
  const Eigen::Matrix3d M_inv = params.M().inverse();
  const Vector3 f_e = params.M() * params.g;                   // eq. (2)
  const Contact contact = get_contacts(q, params);

  // eq. (11)
  if (contact.phi < delta) {
    const Vector3 J_t = contact.J.col(0);
    const Vector3 J_n = contact.J.col(1);
    const Lcp lcp = form_lcp(contact.J, v, params);
    const Vector3 f = solve_lcp(lcp.V, lcp.p);
    const double f_n = f(0), f_t1 = f(1), f_t2 = f(2);

    // eq. (13)
    const Vector3 v_next = v + dt * M_inv * (f_e + J_n * f_n - J_t * f_t1 + J_t * f_t2);
    // eq. (14)
    const Vector3 q_next = q + dt * v_next + Vector3(0, delta, 0);
    return {q_next, v_next};
  }

  // eq. (12)
  const Vector3 v_next = v + dt * M_inv * f_e;
  const Vector3 q_next = q + dt * v_next;
  return {q_next, v_next};
}

}  // namespace bounce
