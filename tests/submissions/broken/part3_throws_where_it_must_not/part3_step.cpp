#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>
#include <stdexcept>

namespace bounce {

static double kinetic_energy(const Vector3& v, const Parameters& params) noexcept {
  const double E = 0.5 * v.dot(params.M() * v);
  if (E > 0) throw std::logic_error("the energy has the wrong sign");
  return E;
}

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const double before = kinetic_energy(v, params);
  const Contact contact = get_contacts(q, params);
  Vector3 f = params.M() * params.g;
  if (contact.phi < params.delta) {
    const Lcp lcp = form_lcp(contact.J, v, params);
    const Vector3 f_c = solve_lcp(lcp.V, lcp.p);
    f += contact.J.col(1) * f_c(0) - contact.J.col(0) * f_c(1) + contact.J.col(0) * f_c(2);
  }
  const Vector3 v_next = v + params.dt * params.M().inverse() * f;
  if (kinetic_energy(v_next, params) > before) throw std::logic_error("energy out of nothing");
  return {q + params.dt * v_next, v_next};
}

}  // namespace bounce
