#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  Vector3 force = params.M() * params.g;
  Vector3 lift = Vector3::Zero();
  const Contact contact = get_contacts(q, params);
  if (contact.phi < params.delta) {
    const Lcp lcp = form_lcp(contact.J, v, params);
    const auto z = solve_lcp(lcp.V, lcp.p);
    force += contact.J.col(1) * z(0) + contact.J.col(0) * (z(2) - z(1));
    lift(1) = params.delta;
  }
  auto v_next = v + params.dt * (params.M().inverse() * force);
  const Vector3 q_next = q + params.dt * v_next + lift;
  return {q_next, v_next};
}

}  // namespace bounce
