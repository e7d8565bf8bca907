#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>
#include <cmath>

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const Eigen::Matrix3d M = params.M();
  const Vector3 f_e = M * params.g;

  Vector3 f = f_e;
  Vector3 q_p = Vector3::Zero();
  const auto [J, phi] = get_contacts(q, params);
  if (phi < params.delta) {
    const auto [V, p] = form_lcp(J, v, params);
    const Vector3 f_c = solve_lcp(V, p);
    f += J.col(1) * f_c(0) - J.col(0) * f_c(1) + J.col(0) * f_c(2);
    q_p.y() = params.delta;
  }

  const Vector3 v_next = v + params.dt * M.inverse() * f;
  State next{q + params.dt * v_next + q_p, v_next};
  next.q(2) = next.q(2) - 2 * 3.14159265358979323846 * std::floor(next.q(2) / (2 * 3.14159265358979323846));
  return next;
}

}
