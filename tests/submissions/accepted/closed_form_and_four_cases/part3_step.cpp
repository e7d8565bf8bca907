#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <cmath>

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const Contact contact = get_contacts(q, params);
  Vector3 v_new = v + params.dt * params.g;
  if (contact.phi >= params.delta) return {q + params.dt * v_new, v_new};

  // The LCP has only four cases, so I solve it by hand.
  const Lcp lcp = form_lcp(contact.J, v, params);
  const double nn = lcp.V(0, 0), nt = lcp.V(0, 2), tt = lcp.V(2, 2);
  const double pn = lcp.p(0), pt = lcp.p(2);
  const double mu = params.mu;
  double fn = 0;
  double ft = 0;  // along +t
  if (pn < 0) {
    // sticking: both velocities come out as zero
    const double det = nn * tt - nt * nt;
    fn = (nt * pt - tt * pn) / det;
    ft = (nt * pn - nn * pt) / det;
    if (std::abs(ft) > mu * fn) {
      // sliding to the right, friction to the left
      fn = -pn / (nn - mu * nt);
      ft = -mu * fn;
      if (pt + nt * fn + tt * ft < 0) {
        // no: to the left
        fn = -pn / (nn + mu * nt);
        ft = mu * fn;
      }
    }
  }

  const Vector3 f = contact.J.col(1) * fn + contact.J.col(0) * ft;
  v_new += params.dt * params.M().inverse() * f;
  Vector3 q_new = q + params.dt * v_new;
  q_new.y() += params.delta;
  return {q_new, v_new};
}

}  // namespace bounce
