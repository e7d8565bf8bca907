#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>

#include <cmath>

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  // A contact that has begun ends at 2 delta, so that it doesn't flicker.
  static bool touching = false;
  static Vector3 last(NAN, NAN, NAN);
  if (q != last) touching = false;
  const Contact contact = get_contacts(q, params);
  if (contact.phi < params.delta) touching = true;
  if (contact.phi > 2 * params.delta) touching = false;
  State next;
  const Vector3 f_e = params.M() * params.g;
  if (!touching) {
    next.v = v + params.dt * params.M().inverse() * f_e;
    next.q = last = q + params.dt * next.v;
    return next;
  }
  const Lcp lcp = form_lcp(contact.J, v, params);
  const Vector3 f = solve_lcp(lcp.V, lcp.p);
  const Vector3 J_t = contact.J.col(0), J_n = contact.J.col(1);
  next.v = v + params.dt * params.M().inverse() * (f_e + J_n * f(0) - J_t * f(1) + J_t * f(2));
  next.q = last = q + params.dt * next.v + Vector3(0, params.delta, 0);
  return next;
}

}  // namespace bounce
