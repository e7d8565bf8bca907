#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>
#include <cmath>

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const Vector3 root = params.M().diagonal().cwiseSqrt();
  const Contact contact = get_contacts(q, params);
  const bool touching = contact.phi < params.delta;

  Vector3 u = root.cwiseProduct(v + params.dt * params.g);
  if (touching) {
    const Lcp lcp = form_lcp(contact.J, v, params);
    const Vector3 f = solve_lcp(lcp.V, lcp.p);
    const Vector3 force = contact.J * Eigen::Vector2d(f(2) - f(1), f(0));
    u += params.dt * force.cwiseQuotient(root);
  }
  const Vector3 v_next = u.cwiseQuotient(root);
  const Vector3 q_next = q + params.dt * v_next + Vector3(0, touching ? params.delta : 0, 0);
  return {q_next, v_next};
}

}  // namespace bounce
