#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>

namespace bounce {

static State half(const Vector3& q, const Vector3& v, const Parameters& params) {
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
  return {q + params.dt * v_next + q_p, v_next};
}

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  Parameters shorter = params;
  shorter.dt /= 2;
  const State middle = half(q, v, shorter);
  return half(middle.q, middle.v, shorter);
}

}
