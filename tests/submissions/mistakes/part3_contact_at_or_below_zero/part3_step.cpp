#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>

namespace bounce {

static bool touching(double phi) { return phi <= 0.0; }

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  auto [J, phi] = get_contacts(q, params);
  Vector3 total = params.M() * params.g;
  double lift = 0;

  if (touching(phi)) {
    auto [V, p] = form_lcp(J, v, params);
    Vector3 f = solve_lcp(V, p);
    total += J.col(1) * f[0] - J.col(0) * f[1] + J.col(0) * f[2];
    lift = params.delta;
  }

  State next;
  next.v = v + params.dt * params.M().inverse() * total;
  next.q = q + params.dt * next.v;
  next.q[1] += lift;
  return next;
}

}  // namespace bounce
