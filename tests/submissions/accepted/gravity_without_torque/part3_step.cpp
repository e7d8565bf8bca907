#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  Contact contact = get_contacts(q, params);
  Vector3 force(params.m * params.g(0), params.m * params.g(1), 0);  // gravity does not turn it
  Vector3 lift = Vector3::Zero();

  if (contact.phi < params.delta) {
    Lcp lcp = form_lcp(contact.J, v, params);
    Vector3 f = solve_lcp(lcp.V, lcp.p);
    force += contact.J.col(1) * f(0) + contact.J.col(0) * (f(2) - f(1));
    lift(1) = params.delta;
  }

  State next;
  next.v(0) = v(0) + params.dt * force(0) / params.m;
  next.v(1) = v(1) + params.dt * force(1) / params.m;
  next.v(2) = v(2) + params.dt * force(2) / (params.m * params.l * params.l / 6);
  next.q = q + params.dt * next.v + lift;
  return next;
}

}  // namespace bounce
