#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>

#include "corners.hpp"

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  Vector3 f = params.M() * params.g;
  Vector3 lift = Vector3::Zero();
  if (corner(lowest_corner(q, params), q, params).y() < params.delta) {
    const Jacobian J = get_contacts(q, params).J;
    const Lcp lcp = form_lcp(J, v, params);
    const Vector3 f_c = solve_lcp(lcp.V, lcp.p);
    f += J.col(1) * f_c(0) + J.col(0) * (f_c(2) - f_c(1));
    lift(1) = params.delta;
  }
  const Vector3 v_next = v + params.dt * params.M().inverse() * f;
  return {q + params.dt * v_next + lift, v_next};
}

}  // namespace bounce
