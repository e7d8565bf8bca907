// The program that carries a submission: reads a question, calls the submission, writes the
// answer, until the judge closes the pipe. It knows no right answer and decides nothing.
#include <sys/prctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <new>

#include "channel.hpp"

// A runner is linked from the parts at hand; a function that isn't there is null.
namespace bounce {
[[gnu::weak]] Contact get_contacts(const Vector3& q, const Parameters& params);
[[gnu::weak]] Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params);
[[gnu::weak]] State step(const Vector3& q, const Vector3& v, const Parameters& params);
[[gnu::weak]] Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params);
}  // namespace bounce

namespace bounce::runner {
namespace {

using frames::Frame;
using frames::Kind;

void answer_part1(const Frame& question, Frame& answer) {
  Vector3 q;
  frames::take(question, q);
  const Contact contact = get_contacts(q, frames::parameters(question));
  frames::put(answer, contact.J);
  answer.values[6] = contact.phi;
}

void answer_part2(const Frame& question, Frame& answer) {
  Jacobian J;
  Vector3 v;
  frames::take(question, J, v);
  const Lcp lcp = form_lcp(J, v, frames::parameters(question));
  frames::put(answer, lcp.V, lcp.p);
}

void answer_part3(const Frame& question, Frame& answer) {
  Vector3 q, v;
  frames::take(question, q, v);
  const State next = step(q, v, frames::parameters(question));
  frames::put(answer, next.q, next.v);
}

Trajectory answer_part4(const Frame& question, Frame& answer) {
  Vector3 q_0, v_0;
  frames::take(question, q_0, v_0);
  Trajectory trajectory = simulate(q_0, v_0, frames::parameters(question));
  answer.q_columns = trajectory.q.cols();
  answer.v_columns = trajectory.v.cols();
  return trajectory;
}

bool present(std::uint32_t part) {
  return (part == 1 && get_contacts) || (part == 2 && form_lcp) || (part == 3 && step) ||
         (part == 4 && simulate);
}

// The answer, and the trajectory that goes with one of part 4.
Frame answer_to(const Frame& question, Trajectory& trajectory) {
  Frame answer;
  answer.kind = Kind::answer;
  answer.part = question.part;
  answer.number = question.number;
  try {
    if (!present(question.part)) {
      answer.kind = Kind::absent;
    } else if (question.part == 1) {
      answer_part1(question, answer);
    } else if (question.part == 2) {
      answer_part2(question, answer);
    } else if (question.part == 3) {
      answer_part3(question, answer);
    } else {
      trajectory = answer_part4(question, answer);
    }
  } catch (const ChannelClosed&) {
    throw;
  } catch (const std::bad_alloc&) {
    answer.kind = Kind::out_of_memory;
  } catch (const std::exception& thrown) {
    answer.kind = Kind::threw;
    frames::put_text(answer, thrown.what());
  } catch (...) {
    answer.kind = Kind::threw;
    frames::put_text(answer, "something that is not a std::exception");
  }
  return answer;
}

// The first T, or one less: as many as the judge then reads.
void send_columns(const Frame& question, const Frame& answer, const Trajectory& trajectory) {
  const std::int64_t columns = std::min({answer.q_columns, answer.v_columns, question.T});
  if (columns < 1 || columns < question.T - 1) return;
  send(trajectory.q.leftCols(columns));
  send(trajectory.v.leftCols(columns));
}

void serve() {
  while (true) {
    const Frame question = receive();
    Trajectory trajectory;
    const Frame answer = answer_to(question, trajectory);
    send(answer);
    if (question.part == 4 && question.silent == 0) send_columns(question, answer, trajectory);
  }
}

}  // namespace
}  // namespace bounce::runner

int main() {
  ::prctl(PR_SET_PDEATHSIG, 9);  // without a box, too, nothing outlives the judge
  try {
    bounce::runner::serve();
  } catch (const bounce::runner::ChannelClosed&) {
  }
  std::_Exit(0);
}
