#include <bounce/part2_lcp.hpp>

namespace bounce {

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  const double m = params.m;
  const Vector3 w(1 / m, 1 / m, 6 / (m * params.l * params.l));  // diagonal of M^-1
  const auto n = J.col(1);
  const auto t = J.col(0);

  const double nn = params.dt * (n.array() * w.array() * n.array()).sum();
  const double nt = params.dt * (n.array() * w.array() * t.array()).sum();
  const double tt = params.dt * (t.array() * w.array() * t.array()).sum();

  Eigen::Matrix4d V;
  V.row(0) << nn, -nt, nt, 0;
  V.row(1) << -nt, tt, -tt, 1;
  V.row(2) << nt, -tt, tt, 1;
  V.row(3) << params.mu, -1, -1, 0;

  const double un = n.dot(v) + params.epsilon * n.dot(v) + params.dt * n.dot(params.g);
  const double ut = t.dot(v) + params.dt * t.dot(params.g);
  return {V, Eigen::Vector4d(un, -ut, ut, 0)};
}

}  // namespace bounce
