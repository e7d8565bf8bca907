#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const double dt = params.dt;
  const Eigen::Matrix3d M = params.M();
  const Vector3 f_e = M * params.g;

  Vector3 q_next = q + dt * v;
  Vector3 v_next = v + dt * M.inverse() * f_e;

  const Contact contact = get_contacts(q, params);
  if (contact.phi < params.delta) {
    const Lcp lcp = form_lcp(contact.J, v, params);
    const Vector3 f_c = solve_lcp(lcp.V, lcp.p);
    Eigen::Matrix3d J_hat;
    J_hat << contact.J.col(1), -contact.J.col(0), contact.J.col(0);
    v_next += dt * M.inverse() * J_hat * f_c;
    q_next(1) += params.delta;
  }
  return {q_next, v_next};
}

}  // namespace bounce
