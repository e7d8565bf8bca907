#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const Contact contact = get_contacts(q, params);
  const double hit = contact.phi < params.delta;
  const Lcp lcp = form_lcp(contact.J, v, params);
  const Vector3 f = hit > 0 ? solve_lcp(lcp.V, lcp.p) : Vector3::Zero().eval();
  const Vector3 v1 = v + params.dt * (params.g + params.M().diagonal().asDiagonal().inverse() *
                                                     (contact.J * Eigen::Vector2d(f(2) - f(1), f(0))));
  return {q + params.dt * v1 + hit * params.delta * Vector3::UnitY(), v1};
}

}  // namespace bounce
