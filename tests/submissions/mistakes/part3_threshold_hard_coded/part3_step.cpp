#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const auto [J, phi] = get_contacts(q, params);
  const bool inContact = phi < 0.001;

  Vector3 force = params.M() * params.g;
  if (inContact) {
    const auto [V, p] = form_lcp(J, v, params);
    const Vector3 f = solve_lcp(V, p);
    force += J.col(1) * f(0) - J.col(0) * f(1) + J.col(0) * f(2);
  }

  State next;
  next.v = v + params.dt * params.M().inverse() * force;
  next.q = q + params.dt * next.v;
  if (inContact) next.q(1) += params.delta;
  return next;
}

}  // namespace bounce
