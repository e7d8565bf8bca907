#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const Contact contact = get_contacts(q, params);
  const Eigen::Matrix3d M_inv = params.M().inverse();
  Vector3 force = params.M() * params.g;
  Vector3 lift = Vector3::Zero();

  if (contact.phi < params.delta) {
    const Lcp lcp = form_lcp(contact.J, v, params);
    const Vector3 f = solve_lcp(lcp.V, lcp.p);
    force += contact.J.col(1) * f(0) - contact.J.col(0) * f(1) + contact.J.col(0) * f(2);
    lift(1) = params.delta;
  }

  const Vector3 v_next = v + params.dt * M_inv * force;
  const Vector3 q_next = q + params.dt * v_next + lift;
  return {q_next, v_next};
}

}  // namespace bounce
