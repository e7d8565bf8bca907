// The program that a submission is linked into: reads a question, calls the submission, writes the
// answer, until the judge closes the pipe. It knows no right answer and decides nothing.
#include <sys/prctl.h>
#include <unistd.h>

#include <algorithm>
#include <bounce/render.hpp>
#include <cstdlib>
#include <exception>
#include <new>
#include <type_traits>
#include <utility>

#include "../../tests/parts/functions.hpp"
#include "channel.hpp"
#include "crash.hpp"

// Weak, because a runner need not hold every part; a missing function is null.
namespace bounce {
#define BOUNCE_WEAK(number, function) [[gnu::weak]] decltype(bounce::function) function;
BOUNCE_FUNCTIONS(BOUNCE_WEAK)

// What a submission draws while it is judged is seen by nobody.
void render(const Eigen::Matrix3Xd&, const Parameters&, const std::filesystem::path&) {}
void render(const Trajectory&, const Parameters&, const std::filesystem::path&) {}
}  // namespace bounce

namespace bounce::runner {
namespace {

using frames::Frame;
using frames::Kind;

// Runs before the submission's constructors: 101 is the first priority that isn't reserved.
[[gnu::constructor(101)]] void prepare() {
  report_crashes();
  ask_earlier_part = call_back;
}

// Calls the function that the question asks for, if it is there.
void call(const Frame& question, Frame& answer, Trajectory& trajectory) {
  answer.kind = Kind::absent;
  const auto call = [&](auto* function) {
    if (!function) return;
    answer.kind = Kind::answer;
    auto result = frames::answer(question, answer, function);
    if constexpr (std::is_same_v<decltype(result), Trajectory>) trajectory = std::move(result);
  };
#define BOUNCE_CALL(number, function) \
  if (question.part == number) call(bounce::function);
  BOUNCE_FUNCTIONS(BOUNCE_CALL)
}

// The answer; for part 4 also the trajectory.
Frame answer_to(const Frame& question, Trajectory& trajectory) {
  Frame answer;
  answer.part = question.part;
  answer.number = question.number;
  try {
    call(question, answer, trajectory);
  } catch (const ChannelClosed&) {
    throw;
  } catch (const std::bad_alloc&) {
    answer.kind = Kind::out_of_memory;
  } catch (const std::exception& thrown) {
    answer.kind = Kind::threw;
    frames::put_text(answer, thrown.what());
  } catch (const char* text) {
    answer.kind = Kind::threw;
    frames::put_text(answer, text);
  } catch (const std::string& text) {
    answer.kind = Kind::threw;
    frames::put_text(answer, text.c_str());
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
    if (question.part == 4) send_columns(question, answer, trajectory);
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
