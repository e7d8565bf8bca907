#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>

#include "enumerate_lcp.hpp"

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const Contact contact = get_contacts(q, params);
  const Eigen::Matrix3d M_inv = params.M().inverse();
  Vector3 v_next = v + params.dt * M_inv * (params.M() * params.g);
  Vector3 q_p = Vector3::Zero();
  if (contact.phi < params.delta) {
    const Lcp lcp = form_lcp(contact.J, v, params);
    const Eigen::Vector4d z = enumerate_lcp(lcp.V, lcp.p);
    v_next += params.dt * M_inv * (contact.J.col(1) * z(0) + contact.J.col(0) * (z(2) - z(1)));
    q_p(1) = params.delta;
  }
  return {q + params.dt * v_next + q_p, v_next};
}

}  // namespace bounce
