#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const Eigen::Matrix3d M_inv = params.M().inverse();
  const Vector3 f_e = params.M() * params.g;
  const Contact contact = get_contacts(q, params);

  Vector3 f = f_e;
  Vector3 lift(0, 0, 0);
  if (contact.phi > params.delta) {
    const Lcp lcp = form_lcp(contact.J, v, params);
    const Vector3 f_c = solve_lcp(lcp.V, lcp.p);
    f += contact.J.col(1) * f_c(0) + contact.J.col(0) * (f_c(2) - f_c(1));
    lift(1) = params.delta;
  }
  const Vector3 v_next = v + params.dt * M_inv * f;
  return {q + params.dt * v_next + lift, v_next};
}

}  // namespace bounce
