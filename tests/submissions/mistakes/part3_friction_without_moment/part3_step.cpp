#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const Contact contact = get_contacts(q, params);
  const double inertia = params.m * params.l * params.l / 6;

  // forces and moment on the centre of mass
  double F_x = params.m * params.g(0);
  double F_y = params.m * params.g(1);
  double torque = 0;
  if (contact.phi < params.delta) {
    const Lcp lcp = form_lcp(contact.J, v, params);
    const Vector3 f = solve_lcp(lcp.V, lcp.p);
    F_x += f(2) - f(1);
    F_y += f(0);
    torque += contact.J(2, 1) * f(0);
  }

  State next;
  next.v(0) = v(0) + params.dt * F_x / params.m;
  next.v(1) = v(1) + params.dt * F_y / params.m;
  next.v(2) = v(2) + params.dt * torque / inertia;
  next.q = q + params.dt * next.v;
  if (contact.phi < params.delta) next.q(1) += params.delta;
  return next;
}

}  // namespace bounce
