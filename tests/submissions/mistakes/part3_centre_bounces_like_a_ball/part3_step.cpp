#include <bounce/part1_contacts.hpp>
#include <bounce/part3_step.hpp>

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const Contact contact = get_contacts(q, params);
  State next;
  if (contact.phi < params.delta) {
    next.v = v;
    next.v(1) = -params.epsilon * v(1);
    next.q = q + params.dt * next.v + Vector3(0, params.delta, 0);
  } else {
    next.v = v + params.dt * params.g;
    next.q = q + params.dt * next.v;
  }
  return next;
}

}  // namespace bounce
