#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>
#include <iostream>

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const auto contact = get_contacts(q, params);
  Vector3 f = params.M() * params.g;
  if (contact.phi < params.delta) {
    std::cerr << "CONTACT!!! phi = " << contact.phi << std::endl;
    const auto lcp = form_lcp(contact.J, v, params);
    const Vector3 z = solve_lcp(lcp.V, lcp.p);
    std::cerr << "forces " << z.transpose() << std::endl;
    f += contact.J.col(1) * z(0) - contact.J.col(0) * z(1) + contact.J.col(0) * z(2);
  } else {
    std::clog << "free" << std::endl;
  }
  const Vector3 v_next = v + params.dt * params.M().inverse() * f;
  Vector3 q_next = q + params.dt * v_next;
  if (contact.phi < params.delta) q_next(1) += params.delta;
  std::cout << "q: " << q_next.transpose() << "  v: " << v_next.transpose() << '\n';
  return {q_next, v_next};
}

}  // namespace bounce
