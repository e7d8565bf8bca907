#include <bounce/part2_lcp.hpp>

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  const double m = params.m;
  const double I = params.m * params.l * params.l / 6.0;
  const double dt = params.dt;

  // columns of J
  const double t0 = J(0, 0), t1 = J(1, 0), t2 = J(2, 0);
  const double n0 = J(0, 1), n1 = J(1, 1), n2 = J(2, 1);

  // J^T M^-1 J
  const double nn = n0 * n0 / m + n1 * n1 / m + n2 * n2 / I;
  const double nt = n0 * t0 / m + n1 * t1 / m + n2 * t2 / I;
  const double tt = t0 * t0 / m + t1 * t1 / m + t2 * t2 / I;

  Lcp lcp;
  lcp.V(0, 0) = dt * nn;
  lcp.V(0, 1) = -dt * nt;
  lcp.V(0, 2) = dt * nt;
  lcp.V(0, 3) = 0;
  lcp.V(1, 0) = -dt * nt;
  lcp.V(1, 1) = dt * tt;
  lcp.V(1, 2) = -dt * tt;
  lcp.V(1, 3) = 1;
  lcp.V(2, 0) = dt * nt;
  lcp.V(2, 1) = -dt * tt;
  lcp.V(2, 2) = dt * tt;
  lcp.V(2, 3) = 1;
  lcp.V(3, 0) = params.mu;
  lcp.V(3, 1) = -1;
  lcp.V(3, 2) = -1;
  lcp.V(3, 3) = 0;

  const double gx = params.g(0), gy = params.g(1), gz = params.g(2);
  const double v_n = n0 * v(0) + n1 * v(1) + n2 * v(2);
  const double v_t = t0 * v(0) + t1 * v(1) + t2 * v(2);
  const double g_n = n0 * gx + n1 * gy + n2 * gz;
  const double g_t = t0 * gx + t1 * gy + t2 * gz;

  lcp.p(0) = (1 + params.epsilon) * v_n + dt * g_n;
  lcp.p(1) = -(v_t + dt * g_t);
  lcp.p(2) = v_t + dt * g_t;
  lcp.p(3) = 0;
  return lcp;
}

}  // namespace bounce
