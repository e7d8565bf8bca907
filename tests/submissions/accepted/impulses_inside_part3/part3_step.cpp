#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const Contact contact = get_contacts(q, params);
  const Eigen::Matrix3d M_inv = params.M().inverse();
  Vector3 v_next = v + params.dt * params.g;
  if (contact.phi >= params.delta) return {q + params.dt * v_next, v_next};

  // With P = f dt in place of f the block of the forces loses its dt, the rest stays.
  Lcp lcp = form_lcp(contact.J, v, params);
  lcp.V.topLeftCorner<3, 3>() /= params.dt;
  const Vector3 P = solve_lcp(lcp.V, lcp.p);  // N s

  v_next += M_inv * (contact.J.col(1) * P(0) - contact.J.col(0) * P(1) + contact.J.col(0) * P(2));
  return {q + params.dt * v_next + params.delta * Vector3::UnitY(), v_next};
}

}  // namespace bounce
