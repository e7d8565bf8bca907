#include "reference_parts.hpp"

#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <exception>

namespace bounce::judge {
namespace {

using frames::Frame;

void reply_part1(const Frame& callback, Frame& reply) {
  Vector3 q;
  frames::take(callback, q);
  const Contact contact = get_contacts(q, frames::parameters(callback));
  frames::put(reply, contact.J);
  reply.values[6] = contact.phi;
}

void reply_part2(const Frame& callback, Frame& reply) {
  Jacobian J;
  Vector3 v;
  frames::take(callback, J, v);
  const Lcp lcp = form_lcp(J, v, frames::parameters(callback));
  frames::put(reply, lcp.V, lcp.p);
}

void reply_part3(const Frame& callback, Frame& reply) {
  Vector3 q, v;
  frames::take(callback, q, v);
  const State next = step(q, v, frames::parameters(callback));
  frames::put(reply, next.q, next.v);
}

}  // namespace

Frame reply_to(const Frame& callback) {
  Frame reply;
  reply.kind = frames::Kind::answer;
  reply.part = callback.part;
  reply.number = callback.number;
  try {
    if (callback.part == 1) reply_part1(callback, reply);
    if (callback.part == 2) reply_part2(callback, reply);
    if (callback.part == 3) reply_part3(callback, reply);
  } catch (const std::exception& refused) {
    reply.kind = frames::Kind::threw;
    frames::put_text(reply, refused.what());
  }
  return reply;
}

}  // namespace bounce::judge
