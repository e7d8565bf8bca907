#include "reference_parts.hpp"

#include <bounce/part1_contacts.hpp>
#include <bounce/part2_lcp.hpp>
#include <bounce/part3_step.hpp>
#include <exception>

#include "../runner/messages.hpp"

namespace bounce::judge {

using frames::Frame;

Frame reply_to(const Frame& callback) {
  Frame reply;
  reply.kind = frames::Kind::answer;
  reply.part = callback.part;
  reply.number = callback.number;
  try {
    if (callback.part == 1) frames::answer(callback, reply, get_contacts);
    if (callback.part == 2) frames::answer(callback, reply, form_lcp);
    if (callback.part == 3) frames::answer(callback, reply, step);
  } catch (const std::exception& refused) {
    reply.kind = frames::Kind::threw;
    frames::put_text(reply, refused.what());
  }
  return reply;
}

}  // namespace bounce::judge
