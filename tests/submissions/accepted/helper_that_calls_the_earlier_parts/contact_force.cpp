#include "contact_force.hpp"

#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/solve_lcp.hpp>

bounce::Vector3 contact_force(const bounce::Contact& contact, const bounce::Vector3& v, const bounce::Parameters& params) {
  if (contact.phi >= params.delta) return bounce::Vector3::Zero();
  const bounce::Lcp lcp = bounce::form_lcp(contact.J, v, params);
  const bounce::Vector3 f = bounce::solve_lcp(lcp.V, lcp.p);
  return contact.J.col(1) * f(0) - contact.J.col(0) * f(1) + contact.J.col(0) * f(2);
}

bool in_contact(const bounce::Vector3& q, const bounce::Parameters& params) {
  return bounce::get_contacts(q, params).phi < params.delta;
}
