#include <bounce/part2_lcp.hpp>
#include <complex>

namespace bounce {

namespace {

using Complex = std::complex<double>;

// a planar motion or force: the translation as a complex number, and the turn
struct Twist {
  Complex lin;
  double ang;
};

Twist twist(const Vector3& a) { return {Complex(a(0), a(1)), a(2)}; }

double dot(const Twist& a, const Twist& b) {
  return (std::conj(a.lin) * b.lin).real() + a.ang * b.ang;
}

}  // namespace

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  const double I = params.m * params.l * params.l / 6;
  const Twist n = twist(J.col(1));
  const Twist t = twist(J.col(0));
  const Twist Mn{n.lin / params.m, n.ang / I};
  const Twist Mt{t.lin / params.m, t.ang / I};
  const Twist w = twist(v);
  const Twist g = twist(params.g);

  const double a = params.dt * dot(n, Mn);
  const double b = params.dt * dot(n, Mt);
  const double d = params.dt * dot(t, Mt);

  Lcp lcp;
  lcp.V << a, -b, b, 0,
          -b, d, -d, 1,
           b, -d, d, 1,
           params.mu, -1, -1, 0;
  const double u_n = (1 + params.epsilon) * dot(n, w) + params.dt * dot(n, g);
  const double u_t = dot(t, w) + params.dt * dot(t, g);
  lcp.p << u_n, -u_t, u_t, 0;
  return lcp;
}

}  // namespace bounce
