// Part 1, given: the judge answers.
#include <bounce/part1_contacts.hpp>

#include "channel.hpp"

namespace bounce {

Contact get_contacts(const Vector3& q, const Parameters& params) {
  frames::Frame callback;
  callback.part = 1;
  frames::put(params, callback);
  frames::put(callback, q);
  const frames::Frame reply = runner::plead(callback);
  Contact contact;
  frames::take(reply, contact.J);
  contact.phi = reply.values[6];
  return contact;
}

}  // namespace bounce
