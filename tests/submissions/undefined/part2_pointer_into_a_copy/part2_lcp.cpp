#include <bounce/part2_lcp.hpp>

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  const double* n = Vector3(J.col(1)).data();
  const double* t = Vector3(J.col(0)).data();
  const double m[3] = {params.m, params.m, params.m * params.l * params.l / 6};

  double nn = 0, nt = 0, tt = 0, pn = 0, pt = 0;
  for (int i = 0; i < 3; ++i) {
    nn += n[i] * n[i] / m[i];
    nt += n[i] * t[i] / m[i];
    tt += t[i] * t[i] / m[i];
    pn += n[i] * (v(i) + params.dt * params.g(i)) + params.epsilon * n[i] * v(i);
    pt += t[i] * (v(i) + params.dt * params.g(i));
  }
  const double dt = params.dt;
  Lcp lcp;
  lcp.V << dt * nn, -dt * nt, dt * nt, 0,
      -dt * nt, dt * tt, -dt * tt, 1,
      dt * nt, -dt * tt, dt * tt, 1,
      params.mu, -1, -1, 0;
  lcp.p << pn, -pt, pt, 0;
  return lcp;
}

}  // namespace bounce
