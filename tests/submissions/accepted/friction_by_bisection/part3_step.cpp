#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const Contact contact = get_contacts(q, params);
  Vector3 v_new = v + params.dt * params.g;
  if (contact.phi >= params.delta) return {q + params.dt * v_new, v_new};

  const Lcp lcp = form_lcp(contact.J, v, params);
  const double nn = lcp.V(0, 0), nt = lcp.V(0, 2), tt = lcp.V(2, 2);
  const double pn = lcp.p(0), pt = lcp.p(2);
  const double mu = params.mu;

  // Friction is f_t = s mu f_n with -1 <= s <= 1. For each s the normal row gives f_n, and what is
  // left is the sliding velocity, here times a positive number. Find the s where it vanishes.
  double fn = 0;
  double ft = 0;
  if (pn < 0) {
    const auto sliding = [&](double s) { return pt * (nn + s * mu * nt) - pn * (nt + s * mu * tt); };
    double s;
    if (sliding(-1) >= 0) {
      s = -1;  // slides to the right
    } else if (sliding(1) <= 0) {
      s = 1;   // slides to the left
    } else {
      double low = -1, high = 1;
      for (int k = 0; k < 100; ++k) {
        s = (low + high) / 2;
        (sliding(s) < 0 ? low : high) = s;
      }
    }
    fn = -pn / (nn + s * mu * nt);
    ft = s * mu * fn;
  }

  const Vector3 f = contact.J.col(1) * fn + contact.J.col(0) * ft;
  v_new += params.dt * params.M().inverse() * f;
  Vector3 q_new = q + params.dt * v_new;
  q_new.y() += params.delta;
  return {q_new, v_new};
}

}  // namespace bounce
