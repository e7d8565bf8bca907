#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <algorithm>
#include <cmath>

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const Contact contact = get_contacts(q, params);
  const Eigen::Matrix3d M_inv = params.M().inverse();
  Vector3 force = params.M() * params.g;
  Vector3 lift = Vector3::Zero();

  if (contact.phi < params.delta) {
    const Lcp lcp = form_lcp(contact.J, v, params);

    // projected Gauss-Seidel for f_n and f_t = f_t2 - f_t1
    double f_n = 0;
    double f_t = 0;
    for (int k = 0; k < 20000; ++k) {
      f_n = std::max(0.0, -(lcp.p(0) + lcp.V(0, 2) * f_t) / lcp.V(0, 0));
      const double limit = params.mu * f_n;
      const double next = std::clamp(-(lcp.p(2) + lcp.V(2, 0) * f_n) / lcp.V(2, 2), -limit, limit);
      const double change = std::abs(next - f_t);
      f_t = next;
      if (change <= 1e-15 * f_n) break;
    }
    f_n = std::max(0.0, -(lcp.p(0) + lcp.V(0, 2) * f_t) / lcp.V(0, 0));

    force += contact.J.col(1) * f_n + contact.J.col(0) * f_t;
    lift(1) = params.delta;
  }

  const Vector3 v_next = v + params.dt * M_inv * force;
  const Vector3 q_next = q + params.dt * v_next + lift;
  return {q_next, v_next};
}

}  // namespace bounce
