#include "lcp_answers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bounce::tests {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

Units units(const Lcp& lcp) {
  const double velocity = lcp.p.cwiseAbs().maxCoeff(), a = lcp.V.diagonal().cwiseAbs().maxCoeff();
  return {velocity, a > 0.0 ? velocity / a : velocity};
}

double residual(const Lcp& lcp, const Vector4d& z, const Units& unit) {
  const Vector4d of_z(unit.force, unit.force, unit.force, unit.velocity);
  const Vector4d of_w(unit.velocity, unit.velocity, unit.velocity, unit.force);
  const Vector4d w = lcp.V * z + lcp.p, sums = lcp.V.cwiseAbs() * z + lcp.p.cwiseAbs();
  if (!z.allFinite() || !sums.allFinite()) return kInfinity;
  const Vector4d least = z.cwiseQuotient(of_z).cwiseMin(w.cwiseQuotient(of_w));
  return least.cwiseAbs().maxCoeff() / std::min(sums.cwiseQuotient(of_w).maxCoeff(), 1e6);
}

double residual(const Lcp& lcp, const Vector3& f, const Units& unit) {
  if (lcp.p.isZero(0.0)) return f.isZero(0.0) ? 0.0 : kInfinity;
  Vector4d z(f.x(), f.y(), f.z(), 0.0);
  const Vector4d w = lcp.V * z + lcp.p;
  double least = residual(lcp, z, unit);
  for (int i = 0; i < 4; ++i) {
    z(3) = -w(i) / lcp.V(i, 3);
    if (z(3) > 0.0) least = std::min(least, residual(lcp, z, unit));
  }
  return least;
}

ContactForces by_cases(const Numbers& n) {
  if (n.u_n >= 0.0) return {separates, 0.0, 0.0};
  const double determinant = n.a * n.c - n.b * n.b;
  const double f_n = (n.b * n.u_t - n.c * n.u_n) / determinant;
  const double f = (n.b * n.u_n - n.a * n.u_t) / determinant;
  if (std::abs(f) <= n.mu * f_n) return {sticks, f_n, f};
  const double left = -n.u_n / (n.a + n.mu * n.b), right = -n.u_n / (n.a - n.mu * n.b);
  if (n.u_t + (n.b - n.mu * n.c) * right > 0.0) return {slides_right, right, -n.mu * right};
  return {slides_left, left, n.mu * left};
}

Vector3 velocity_after(const Scene& scene, double f_n, double f) {
  const Parameters& params = scene.params;
  const double moment = scene.r_x * f_n - scene.r_y * f, s = 6.0 / (params.l * params.l);
  const Vector3 change = params.dt / params.m * Vector3(f, f_n, s * moment);
  return (scene.v + params.dt * params.g + change).cwiseProduct(Vector3(1.0, 1.0, params.l));
}

}  // namespace bounce::tests
