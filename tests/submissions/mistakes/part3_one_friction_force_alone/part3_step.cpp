#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const Contact contact = get_contacts(q, params);
  const Vector3 J_t = contact.J.col(0);
  const Vector3 J_n = contact.J.col(1);
  const Eigen::Matrix3d M_inv = params.M().inverse();
  Vector3 f = params.M() * params.g;
  Vector3 lift = Vector3::Zero();
  if (contact.phi < params.delta) {
    const Lcp lcp = form_lcp(contact.J, v, params);
    const Vector3 z = solve_lcp(lcp.V, lcp.p);
    f += J_n * z(0) + J_t * z(2);
    lift(1) = params.delta;
  }
  const Vector3 v_next = v + params.dt * M_inv * f;
  return {q + params.dt * v_next + lift, v_next};
}

}  // namespace bounce
