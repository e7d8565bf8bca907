#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>
#include <cstdlib>
#include <iostream>

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const Contact contact = get_contacts(q, params);
  std::cout << "phi = " << contact.phi << std::endl;
  exit(0);  // only part 1 for the moment

  Vector3 f = params.M() * params.g;
  if (contact.phi < params.delta) {
    const Lcp lcp = form_lcp(contact.J, v, params);
    const Vector3 f_c = solve_lcp(lcp.V, lcp.p);
    f += contact.J.col(1) * f_c(0) - contact.J.col(0) * f_c(1) + contact.J.col(0) * f_c(2);
  }
  const Vector3 v_next = v + params.dt * params.M().inverse() * f;
  return {q + params.dt * v_next, v_next};
}

}  // namespace bounce
