#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const auto [J, phi] = get_contacts(q, params);
  const Eigen::Matrix3d M_inv = params.M().inverse();
  Vector3 force = params.M() * params.g;
  Vector3 q_p(0, 0, 0);

  if (phi < params.delta) {
    const auto [V, p] = form_lcp(J, v, params);
    const Vector3 f = solve_lcp(V, p);
    force += -J.col(0) * f(0) + J.col(0) * f(1) + J.col(1) * f(2);
    q_p(1) = params.delta;
  }

  const Vector3 v_next = v + params.dt * M_inv * force;
  return {q + params.dt * v_next + q_p, v_next};
}

}  // namespace bounce
