#include <bounce/part2_lcp.hpp>

namespace bounce {

static double product(const Vector3& a, const Vector3& b, const Vector3& weights) {
  double sum;
  for (int i = 0; i < 3; ++i) sum += a(i) * b(i) / weights(i);
  return sum;
}

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  const Vector3 m = params.M().diagonal(), n = J.col(1), t = J.col(0);
  const Vector3 v_free = v + params.dt * params.g;
  const double nn = params.dt * product(n, n, m), nt = params.dt * product(n, t, m),
               tt = params.dt * product(t, t, m);
  Lcp lcp;
  lcp.V << nn, -nt, nt, 0, -nt, tt, -tt, 1, nt, -tt, tt, 1, params.mu, -1, -1, 0;
  lcp.p << n.dot(v_free + params.epsilon * v), -t.dot(v_free), t.dot(v_free), 0;
  return lcp;
}

}  // namespace bounce
