#include "given.hpp"

#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <exception>

namespace bounce::judge {
namespace {

using frames::Frame;

void reply_part1(const Frame& plea, Frame& reply) {
  Vector3 q;
  frames::take(plea, q);
  const Contact contact = get_contacts(q, frames::parameters(plea));
  frames::put(reply, contact.J);
  reply.values[6] = contact.phi;
}

void reply_part2(const Frame& plea, Frame& reply) {
  Jacobian J;
  Vector3 v;
  frames::take(plea, J, v);
  const Lcp lcp = form_lcp(J, v, frames::parameters(plea));
  frames::put(reply, lcp.V, lcp.p);
}

void reply_part3(const Frame& plea, Frame& reply) {
  Vector3 q, v;
  frames::take(plea, q, v);
  const State next = step(q, v, frames::parameters(plea));
  frames::put(reply, next.q, next.v);
}

}  // namespace

Frame reply_to(const Frame& plea) {
  Frame reply;
  reply.kind = frames::Kind::answer;
  reply.part = plea.part;
  reply.number = plea.number;
  try {
    if (plea.part == 1) reply_part1(plea, reply);
    if (plea.part == 2) reply_part2(plea, reply);
    if (plea.part == 3) reply_part3(plea, reply);
  } catch (const std::exception& refused) {
    reply.kind = frames::Kind::threw;
    frames::put_text(reply, refused.what());
  }
  return reply;
}

}  // namespace bounce::judge
