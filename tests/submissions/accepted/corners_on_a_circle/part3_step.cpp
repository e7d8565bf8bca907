#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const Contact contact = get_contacts(q, params);
  const bool hit = contact.phi < params.delta;

  Eigen::Vector2d f = Eigen::Vector2d::Zero();  // (tangential, normal)
  if (hit) {
    const Lcp lcp = form_lcp(contact.J, v, params);
    const Vector3 z = solve_lcp(lcp.V, lcp.p);
    f << z(2) - z(1), z(0);
  }

  const Vector3 a = params.g + params.M().inverse() * contact.J * f;
  const Vector3 v_new = v + params.dt * a;
  Vector3 q_new = q + params.dt * v_new;
  q_new(1) += hit ? params.delta : 0.0;
  return {q_new, v_new};
}

}  // namespace bounce
