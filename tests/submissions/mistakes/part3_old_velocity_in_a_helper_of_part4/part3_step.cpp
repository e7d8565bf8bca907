#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>
#include "advance.hpp"

namespace bounce {

State advance(const Vector3& q, const Vector3& v, const Parameters& params) {
  const Eigen::Matrix3d M = params.M();
  const Vector3 f_e = M * params.g;

  Vector3 f = f_e;
  Vector3 q_p = Vector3::Zero();
  const auto [J, phi] = get_contacts(q, params);
  if (phi < params.delta) {  // eq. (11)
    const auto [V, p] = form_lcp(J, v, params);
    const Vector3 f_c = solve_lcp(V, p);                             // (f_n, f_t1, f_t2)
    f += J.col(1) * f_c(0) - J.col(0) * f_c(1) + J.col(0) * f_c(2);  // eq. (13)
    q_p.y() = params.delta;  // lifts the square out of what it sank in over the step
  }

  // Eqs. (12) and (14)
  const Vector3 v_next = v + params.dt * M.inverse() * f;
  return {q + params.dt * v + q_p, v_next};
}

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  return advance(q, v, params);
}

}  // namespace bounce
