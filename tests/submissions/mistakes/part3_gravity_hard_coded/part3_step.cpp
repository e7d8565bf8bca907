#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const Vector3 g(0, -9.81, 0);
  const Vector3 f_e = params.M() * g;
  const auto contact = get_contacts(q, params);

  Vector3 f = f_e;
  if (contact.phi < params.delta) {
    const auto lcp = form_lcp(contact.J, v, params);
    const auto z = solve_lcp(lcp.V, lcp.p);
    f += contact.J.col(1) * z(0) - contact.J.col(0) * z(1) + contact.J.col(0) * z(2);
  }

  State s{q, v};
  s.v += params.dt * params.M().inverse() * f;
  s.q += params.dt * s.v;
  if (contact.phi < params.delta) s.q.y() += params.delta;
  return s;
}

}  // namespace bounce
