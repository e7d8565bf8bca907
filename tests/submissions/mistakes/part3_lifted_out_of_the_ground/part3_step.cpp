#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const Contact c = get_contacts(q, params);
  Vector3 v_next = v + params.dt * params.g;
  double lift = 0;
  if (c.phi < params.delta) {
    const Lcp lcp = form_lcp(c.J, v, params);
    const Vector3 f = solve_lcp(lcp.V, lcp.p);
    v_next += params.dt * params.M().inverse() * (c.J.col(1) * f(0) + c.J.col(0) * (f(2) - f(1)));
    lift = params.delta - c.phi;
  }
  return {q + params.dt * v_next + Vector3(0, lift, 0), v_next};
}

}  // namespace bounce
