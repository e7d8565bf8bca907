#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>
#include <cmath>

namespace bounce {

// how far the lowest corner is below the centre
double drop(double theta, double l) {
  return l / 2 * (std::abs(std::sin(theta)) + std::abs(std::cos(theta)));
}

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const Vector3 v_free = v + params.dt * params.g;
  if (q(1) - drop(q(2), params.l) >= params.delta) return {q + params.dt * v_free, v_free};

  const Jacobian J = get_contacts(q, params).J;
  const Lcp lcp = form_lcp(J, v, params);
  const Vector3 f = solve_lcp(lcp.V, lcp.p);
  const Vector3 v_next = v_free + params.dt * params.M().inverse() * (J.col(1) * f(0) - J.col(0) * f(1) + J.col(0) * f(2));
  return {q + params.dt * v_next + Vector3(0, params.delta, 0), v_next};
}

}  // namespace bounce
