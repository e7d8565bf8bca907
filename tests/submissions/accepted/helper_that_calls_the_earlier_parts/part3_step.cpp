#include <bounce/part1_contacts.hpp>
#include <bounce/part3_step.hpp>

#include "contact_force.hpp"

namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const Vector3 f = params.M() * params.g + contact_force(get_contacts(q, params), v, params);
  State next;
  next.v = v + params.dt * params.M().inverse() * f;
  next.q = q + params.dt * next.v;
  if (in_contact(q, params)) next.q.y() += params.delta;
  return next;
}

}  // namespace bounce
