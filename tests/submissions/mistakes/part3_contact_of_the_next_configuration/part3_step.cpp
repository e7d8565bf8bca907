#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const double dt = params.dt;
  const Eigen::Matrix3d M_inv = params.M().inverse();
  const Vector3 f_e = params.M() * params.g;

  // try a free step first and see whether it hits the ground
  State next;
  next.v = v + dt * M_inv * f_e;
  next.q = q + dt * next.v;
  if (get_contacts(next.q, params).phi >= params.delta) return next;

  const Jacobian J = get_contacts(q, params).J;
  const Lcp lcp = form_lcp(J, v, params);
  const Vector3 f = solve_lcp(lcp.V, lcp.p);
  next.v += dt * M_inv * (J.col(1) * f(0) + J.col(0) * (f(2) - f(1)));
  next.q = q + dt * next.v + Vector3(0, params.delta, 0);
  return next;
}

}  // namespace bounce
