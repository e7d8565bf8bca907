#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>
#include <cmath>

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const Contact c = get_contacts(q, params);
  const Eigen::Matrix3d M = params.M();
  const Vector3 f_e = M * params.g;
  Vector3 f_c = Vector3::Zero();
  double lift = 0;

  if (std::abs(c.phi) < params.delta) {
    const Lcp lcp = form_lcp(c.J, v, params);
    const Vector3 z = solve_lcp(lcp.V, lcp.p);
    f_c = z(0) * c.J.col(1) - z(1) * c.J.col(0) + z(2) * c.J.col(0);
    lift = params.delta;
  }

  const Vector3 v_next = v + params.dt * M.inverse() * (f_e + f_c);
  Vector3 q_next = q + params.dt * v_next;
  q_next.y() += lift;
  return {q_next, v_next};
}

}  // namespace bounce
