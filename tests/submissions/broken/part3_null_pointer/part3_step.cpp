#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>

namespace bounce {

Contact* last_contact = nullptr;

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  *last_contact = get_contacts(q, params);
  Vector3 f = params.M() * params.g;
  Vector3 lift = Vector3::Zero();
  if (last_contact->phi < params.delta) {
    const Lcp lcp = form_lcp(last_contact->J, v, params);
    const Vector3 f_c = solve_lcp(lcp.V, lcp.p);
    f += last_contact->J.col(1) * f_c(0) - last_contact->J.col(0) * f_c(1) + last_contact->J.col(0) * f_c(2);
    lift(1) = params.delta;
  }
  const Vector3 v_next = v + params.dt * params.M().inverse() * f;
  return {q + params.dt * v_next + lift, v_next};
}

}  // namespace bounce
