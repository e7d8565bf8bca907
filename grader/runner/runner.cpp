// The program that a submission is linked into: reads a question, calls the submission, writes the
// answer, until the judge closes the pipe. It knows no right answer and decides nothing.
#include <sys/prctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <new>

#include "channel.hpp"

// Weak, because a runner need not hold every part; a missing function is null.
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

Trajectory answer_part4(const Frame& question, Frame& answer) {
  Vector3 q_0, v_0;
  frames::take(question, q_0, v_0);
  Trajectory trajectory = simulate(q_0, v_0, frames::parameters(question));
  answer.q_columns = trajectory.q.cols();
  answer.v_columns = trajectory.v.cols();
  return trajectory;
}

// The answer; for part 4 also the trajectory.
Frame answer_to(const Frame& question, Trajectory& trajectory) {
  Frame answer;
  answer.kind = Kind::answer;
  answer.part = question.part;
  answer.number = question.number;
  try {
    if (question.part == 1 && get_contacts) {
      frames::answer(question, answer, get_contacts);
    } else if (question.part == 2 && form_lcp) {
      frames::answer(question, answer, form_lcp);
    } else if (question.part == 3 && step) {
      frames::answer(question, answer, step);
    } else if (question.part == 4 && simulate) {
      trajectory = answer_part4(question, answer);
    } else {
      answer.kind = Kind::absent;
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
    frames::put_text(answer, frames::kNoException);
  }
  return answer;
}

// Sends the first T columns, or one less: as many as the judge will read.
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
  ::prctl(PR_SET_PDEATHSIG, 9);  // so that it doesn't outlive the judge, even without a box
  try {
    bounce::runner::serve();
  } catch (const bounce::runner::ChannelClosed&) {
  }
  std::_Exit(0);
}
