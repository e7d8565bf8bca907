#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>

#include "helpers/inertia.hpp"

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  Vector3 f = helpers::external_force(params);
  const Contact contact = get_contacts(q, params);
  const bool touches = contact.phi < params.delta;
  if (touches) {
    const Lcp lcp = form_lcp(contact.J, v, params);
    const Vector3 f_c = solve_lcp(lcp.V, lcp.p);
    f += contact.J * Eigen::Vector2d(f_c(2) - f_c(1), f_c(0));
  }
  State next{q, v + params.dt * helpers::inverse_inertia(params) * f};
  next.q += params.dt * next.v;
  if (touches) next.q(1) += params.delta;
  return next;
}

}  // namespace bounce
