#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>

namespace bounce {

// With impulses P = dt f in place of forces: the block of V loses its dt, the rest stays.
State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const double dt = params.dt, delta = params.delta;
  const Contact contact = get_contacts(q, params);
  Vector3 v_next = v + dt * params.g;
  Vector3 q_next = q;

  if (contact.phi < delta) {
    const Vector3 J_t = contact.J.col(0);
    const Vector3 J_n = contact.J.col(1);
    Lcp lcp = form_lcp(contact.J, v, params);
    lcp.V.topLeftCorner<3, 3>() /= dt;
    const Vector3 P = solve_lcp(lcp.V, lcp.p);
    v_next += params.M().inverse() * (J_n * P(0) - J_t * P(1) + J_t * P(2));
    q_next(1) += delta;
  }

  q_next += dt * v_next;
  return {q_next, v_next};
}

}  // namespace bounce
