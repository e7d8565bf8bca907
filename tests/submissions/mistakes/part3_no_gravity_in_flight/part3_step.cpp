#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const Contact contact = get_contacts(q, params);
  if (!(contact.phi < params.delta)) {
    return {q + params.dt * v, v};
  }

  const Eigen::Matrix3d M = params.M();
  const Lcp lcp = form_lcp(contact.J, v, params);
  const Vector3 f = solve_lcp(lcp.V, lcp.p);
  Eigen::Matrix3d J_hat;
  J_hat << contact.J.col(1), -contact.J.col(0), contact.J.col(0);

  const Vector3 v_next = v + params.dt * M.inverse() * (M * params.g + J_hat * f);
  const Vector3 q_next = q + params.dt * v_next + Vector3(0, params.delta, 0);
  return {q_next, v_next};
}

}  // namespace bounce
