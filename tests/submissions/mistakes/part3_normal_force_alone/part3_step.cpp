#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const Contact contact = get_contacts(q, params);
  const Vector3 f_e = params.M() * params.g;
  Vector3 f_c = Vector3::Zero();
  Vector3 up = Vector3::Zero();
  if (contact.phi < params.delta) {
    const Lcp lcp = form_lcp(contact.J, v, params);
    f_c = contact.J.col(1) * solve_lcp(lcp.V, lcp.p)(0);
    up = params.delta * Vector3::UnitY();
  }
  const Vector3 v_next = v + params.dt * params.M().llt().solve(f_e + f_c);
  return {q + params.dt * v_next + up, v_next};
}

}  // namespace bounce
