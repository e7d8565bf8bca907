#include "session.hpp"

#include <sys/random.h>

#include <algorithm>
#include <utility>

#include "../../tests/parts/cases.hpp"
#include "../../tests/parts/submission.hpp"
#include "../runner/messages.hpp"
#include "reference_parts.hpp"
#include "sanitize_line.hpp"

namespace bounce::judge {

using frames::Frame;
using frames::Kind;

namespace {

// A random number, so that no program can write an answer before it has the question.
std::uint64_t nonce() {
  std::uint64_t number = 0;
  if (::getrandom(&number, sizeof number, 0) != sizeof number) {
    throw std::runtime_error("the system gives no random numbers");
  }
  return number;
}

// More than any correct program needs; stops a program that calls back in an endless loop.
std::int64_t most_callbacks(const Frame& question) { return 1000 + 20 * question.T; }

// With the text of what(), as much of it as fits into a frame.
std::string thrown_text(const Frame& answer) {
  const std::string text = frames::text(answer);
  const bool cut = text.size() == sizeof answer.text - 1;
  return (text == frames::kNoException ? "" : "an exception: ") +
         sanitize_line(text, sizeof answer.text) + (cut ? "..." : "");
}

}  // namespace

Session* session = nullptr;

Session::Session(std::vector<std::string> command, Limits limits, std::uint32_t part, bool given)
    : Session([command = std::move(command)](
                  const Limits& now) { return std::make_unique<RunnerProcess>(command, now); },
              limits, part, given, nonce) {}

Session::Session(Start start, Limits limits, std::uint32_t part, bool given, Numbers numbers)
    : start_(std::move(start)),
      limits_(limits),
      part_(part),
      given_(given),
      numbers_(std::move(numbers)),
      hangs_left_(given ? 1 : 2),
      last_question_(Clock::now() + std::chrono::seconds(limits.session_seconds)) {}

std::optional<Session::End> Session::take_end() { return std::exchange(end_, std::nullopt); }

Frame Session::ask(Frame question, Trajectory* columns) {
  try {
    require_time();
  } catch (const tests::Ended& unasked) {
    end_ = End{{"no_answer", unasked.what()}, true};
    throw;
  }
  try {
    if (!runner_) runner_ = start_(limits_);
    question.number = numbers_();
  } catch (const std::exception& failure) {
    fail(failure);
  }
  try {
    const Frame answer = answer_of(question, columns);
    if (answer.kind == Kind::threw) {
      throw std::runtime_error("the program threw " + thrown_text(answer));
    }
    return answer;
  } catch (const KitFailure& failure) {
    fail(failure);
  } catch (const RunnerEnded& ended) {
    end_runner();
    end_ = End{ended.termination, ended.termination.status == "does_not_compile"};
    if (ended.termination.status == "timed_out") --hangs_left_;
    if (ended.waits) hangs_left_ = 0;
    throw tests::Ended(ended.what());
  }
}

void Session::fail(const std::exception& failure) {
  kit_failure_ = failure.what();
  throw tests::Ended(kit_failure_);
}

void Session::require_time() const {
  if (!kit_failure_.empty()) throw tests::Ended(kit_failure_);
  const std::string nothing = "nothing was asked here: ";
  if (hangs_left_ <= 0) {
    throw tests::Ended(nothing + "the part hung before, and its time is used up");
  }
  if (Clock::now() > last_question_ || cpu_seconds_ > limits_.session_cpu_seconds) {
    throw tests::Ended(nothing + "the time for this part, or for the whole grading, is used up");
  }
}

void Session::end_runner() {
  cpu_seconds_ += runner_->spent();
  limits_.idle_seconds = std::max(0.0, limits_.idle_seconds - runner_->idle().count());
  runner_.reset();
}

Frame Session::answer_of(const Frame& question, Trajectory* columns) {
  runner_->send(question);
  Frame answer = runner_->receive();
  for (std::int64_t callbacks = 0; answer.kind == Kind::callback; ++callbacks) {
    if (!answers_for(answer.part)) {
      throw RunnerEnded({"no_answer", "the program asked for what isn't given to it"});
    }
    if (callbacks > most_callbacks(question)) {
      throw RunnerEnded({"timed_out", "the program called earlier parts " +
                                          std::to_string(callbacks) +
                                          " times for one answer: a loop without end, perhaps"});
    }
    runner_->send(reply_to(answer));
    answer = runner_->receive();
  }
  if (answer.kind == Kind::absent) {
    throw RunnerEnded(
        {"does_not_compile",
         "the file defines no " + std::string(frames::kFunctions[part_ - 1]) +
             " that other files can call: it takes the namespace and the arguments of "
             "its header, and neither static nor inline"});
  }
  if (answer.kind == Kind::out_of_memory) throw RunnerEnded(out_of_memory(limits_));
  const bool known = answer.kind == Kind::answer || answer.kind == Kind::threw;
  if (!known || answer.number != question.number || answer.part != question.part) {
    throw RunnerEnded({"no_answer", kNotAskedFor});
  }
  if (columns && answer.kind == Kind::answer) read_columns(question, answer, *columns);
  return answer;
}

void Session::read_columns(const Frame& question, const Frame& answer, Trajectory& into) {
  const Eigen::Index columns =
      submission::columns_at_hand(answer.q_columns, answer.v_columns, static_cast<int>(question.T));
  into = {Eigen::Matrix3Xd(3, columns), Eigen::Matrix3Xd(3, columns)};
  runner_->receive(into.q);
  runner_->receive(into.v);
}

}  // namespace bounce::judge
