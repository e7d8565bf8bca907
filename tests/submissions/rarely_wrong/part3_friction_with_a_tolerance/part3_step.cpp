#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const Eigen::Matrix3d M = params.M();
  const Vector3 f_e = M * params.g;

  Vector3 f = f_e;
  Vector3 q_p = Vector3::Zero();
  const auto [J, phi] = get_contacts(q, params);
  if (phi < params.delta) {  // eq. (11)
    const auto [V, p] = form_lcp(J, v, params);
    Vector3 f_c = solve_lcp(V, p);
    if (std::abs(J.col(0).dot(v)) < 1e-3) f_c(1) = f_c(2) = 0;
    f += J.col(1) * f_c(0) - J.col(0) * f_c(1) + J.col(0) * f_c(2);  // eq. (13)
    q_p.y() = params.delta;  // lifts the square out of what it sank in over the step
  }

  // Eqs. (12) and (14): the configuration moves with the new velocity.
  const Vector3 v_next = v + params.dt * M.inverse() * f;
  return {q + params.dt * v_next + q_p, v_next};
}

}  // namespace bounce
