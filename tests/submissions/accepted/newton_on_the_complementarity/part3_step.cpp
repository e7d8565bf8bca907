#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>
#include <Eigen/LU>

namespace bounce {

// Newton's method on min(z, V z + p) = 0 from several starts; the given solver if none arrives.
static Vector3 forces(const Lcp& lcp) {
  const double size = lcp.V(0, 0), large = lcp.p.cwiseAbs().maxCoeff();
  Eigen::Matrix4d V = lcp.V;
  V.topLeftCorner<3, 3>() /= size;
  for (int start = 0; start < 16; ++start) {
    Eigen::Vector4d z;
    for (int i = 0; i < 4; ++i) z(i) = (start >> i & 1) * 10 * large;
    for (int k = 0; k < 10; ++k) {
      const Eigen::Vector4d w = V * z + lcp.p;
      if (z.cwiseMin(w).cwiseAbs().maxCoeff() <= 1e-14 * large) return z.head(3) / size;
      Eigen::Matrix4d slope = Eigen::Matrix4d::Identity();
      for (int i = 0; i < 4; ++i)
        if (w(i) < z(i)) slope.row(i) = V.row(i);
      z -= slope.partialPivLu().solve(z.cwiseMin(w)).eval();
      if (!z.allFinite()) break;
    }
  }
  return solve_lcp(lcp.V, lcp.p);
}

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  Contact contact = get_contacts(q, params);
  Vector3 f_c = Vector3::Zero(), lift = Vector3::Zero();
  if (contact.phi < params.delta) {
    f_c = forces(form_lcp(contact.J, v, params));
    lift(1) = params.delta;
  }
  const Vector3 force = contact.J * Eigen::Vector2d(f_c(2) - f_c(1), f_c(0));
  const Vector3 v1 = v + params.dt * params.g + params.dt * params.M().lu().solve(force);
  return {q + params.dt * v1 + lift, v1};
}

}  // namespace bounce
