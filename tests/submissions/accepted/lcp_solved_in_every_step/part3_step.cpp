#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const auto [J, phi] = get_contacts(q, params);
  const auto [V, p] = form_lcp(J, v, params);
  const Vector3 f = solve_lcp(V, p);

  const Eigen::Matrix3d M_inv = params.M().inverse();
  const Vector3 f_e = params.M() * params.g;
  const Vector3 v_contact = v + params.dt * M_inv * (f_e + J.col(1) * f(0) - J.col(0) * f(1) + J.col(0) * f(2));
  const Vector3 v_free = v + params.dt * M_inv * f_e;

  const bool touches = phi < params.delta;
  const Vector3 v_next = touches ? v_contact : v_free;
  const Vector3 q_p(0, touches ? params.delta : 0, 0);
  return {q + params.dt * v_next + q_p, v_next};
}

}  // namespace bounce
