#include <bounce/part2_lcp.hpp>

namespace bounce {
namespace {

// What the contact's velocities (v_n, -v_t, v_t) are after a step with these three forces.
Vector3 after(const Vector3& forces, const Jacobian& J, const Vector3& v, const Parameters& params) {
  const Vector3 F = J.col(1) * forces(0) + J.col(0) * (forces(2) - forces(1));
  const Vector3 v_next = v + params.dt * (params.g + params.M().inverse() * F);
  const double v_t = J.col(0).dot(v_next), v_n = J.col(1).dot(v_next);
  return {v_n, -v_t, v_t};
}

}  // namespace

// The step is linear in the forces: column i of the block is what a force of 1 in place i adds.
Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  const Vector3 rest = Vector3::Zero();
  const Vector3 without = after(rest, J, v, params);
  Parameters light = params;
  light.g.setZero();

  Lcp lcp;
  for (int i = 0; i < 3; ++i) lcp.V.col(i) << after(Vector3::Unit(i), J, rest, light), 0;
  lcp.V.col(3) << 0, 1, 1, 0;
  lcp.V.row(3).head(3) << params.mu, -1, -1;
  lcp.p << without + Vector3(params.epsilon * J.col(1).dot(v), 0, 0), 0;
  return lcp;
}

}  // namespace bounce
