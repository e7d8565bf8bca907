#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <bounce/solve_lcp.hpp>

namespace bounce {

namespace {

template <bool touching>
State move(const Vector3& q, const Vector3& v, const Contact& contact, const Parameters& params) {
  const Vector3 w = params.M().diagonal().cwiseInverse();
  Vector3 force = params.M() * params.g;
  if constexpr (touching) {
    const Lcp lcp = form_lcp(contact.J, v, params);
    const Vector3 f = solve_lcp(lcp.V, lcp.p);
    force += contact.J.col(1) * f(0);
    force += contact.J.col(0) * (f(2) - f(1));
  }
  State next;
  next.v = v + params.dt * w.cwiseProduct(force);
  next.q = q + params.dt * next.v;
  if constexpr (touching) next.q(1) += params.delta;
  return next;
}

}  // namespace

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const Contact contact = get_contacts(q, params);
  return contact.phi < params.delta ? move<true>(q, v, contact, params)
                                    : move<false>(q, v, contact, params);
}

}  // namespace bounce
