#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>
#include <cmath>

namespace bounce {

Contact get_contacts(const Vector3& q, const Parameters& params) {
  Eigen::Vector2d r(0, 1e300);
  for (int k = 0; k < 4; ++k) {
    const double a = q(2) + M_PI / 4 + k * M_PI / 2, h = params.l * M_SQRT1_2;
    if (h * std::sin(a) < r.y()) r = {h * std::cos(a), h * std::sin(a)};
  }
  Jacobian J;
  J << 1, 0, 0, 1, -r.y(), r.x();
  return {J, q(1) + r.y()};
}

Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params) {
  Eigen::Matrix3d H;
  H << J.col(1), -J.col(0), J.col(0);
  Lcp lcp;
  lcp.V << H.transpose() * params.M().inverse() * H * params.dt, Vector3(0, 1, 1),
      params.mu, -1, -1, 0;
  lcp.p << H.transpose() * (v + params.dt * params.g), 0;
  lcp.p(0) += params.epsilon * J.col(1).dot(v);
  return lcp;
}

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const Contact c = get_contacts(q, params);
  Vector3 v_next = v + params.dt * params.g, lift(0, 0, 0);
  if (c.phi < params.delta) {
    const Lcp lcp = form_lcp(c.J, v, params);
    const Vector3 f = solve_lcp(lcp.V, lcp.p);
    v_next += params.dt * params.M().inverse() * c.J * Eigen::Vector2d(f(2) - f(1), f(0));
    lift(1) = params.delta;
  }
  return {q + params.dt * v_next + lift, v_next};
}

}  // namespace bounce
