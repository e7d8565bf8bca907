#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  // inverted once only, step is called very often
  static const Eigen::Matrix3d M_inv = params.M().inverse();

  const Contact contact = get_contacts(q, params);
  Vector3 acceleration = params.g;
  if (contact.phi < params.delta) {
    const Lcp lcp = form_lcp(contact.J, v, params);
    const Vector3 f = solve_lcp(lcp.V, lcp.p);
    acceleration += M_inv * (contact.J.col(1) * f(0) - contact.J.col(0) * f(1) + contact.J.col(0) * f(2));
  }

  const Vector3 v_next = v + params.dt * acceleration;
  Vector3 q_next = q + params.dt * v_next;
  if (contact.phi < params.delta) q_next(1) += params.delta;
  return {q_next, v_next};
}

}  // namespace bounce
