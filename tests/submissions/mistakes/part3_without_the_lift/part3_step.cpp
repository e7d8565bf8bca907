#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const Contact c = get_contacts(q, params);
  Vector3 f = params.M() * params.g;
  if (c.phi < params.delta) {
    const Lcp lcp = form_lcp(c.J, v, params);
    const Vector3 z = solve_lcp(lcp.V, lcp.p);
    f += c.J.col(1) * z(0);
    f -= c.J.col(0) * z(1);
    f += c.J.col(0) * z(2);
  }
  const Vector3 v1 = v + params.dt * (params.M().inverse() * f);
  const Vector3 q1 = q + params.dt * v1;
  return {q1, v1};
}

}  // namespace bounce
