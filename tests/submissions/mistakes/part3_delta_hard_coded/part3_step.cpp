#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>

namespace bounce {

constexpr double kDelta = 1e-3;

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const Contact contact = get_contacts(q, params);
  const Vector3 a_free = params.g;
  if (contact.phi >= kDelta) {
    const Vector3 v_next = v + params.dt * a_free;
    return {q + params.dt * v_next, v_next};
  }
  const Lcp lcp = form_lcp(contact.J, v, params);
  const Vector3 f = solve_lcp(lcp.V, lcp.p);
  const Vector3 f_c = contact.J.col(1) * f(0) + contact.J.col(0) * (f(2) - f(1));
  const Vector3 v_next = v + params.dt * (a_free + params.M().inverse() * f_c);
  return {q + params.dt * v_next + kDelta * Vector3::UnitY(), v_next};
}

}  // namespace bounce
