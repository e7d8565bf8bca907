#include "session.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <random>
#include <utility>

#include "../../tests/parts/checks.hpp"
#include "../../tests/parts/submission.hpp"
#include "../runner/messages.hpp"

namespace bounce::judge {

using frames::Frame;
using frames::Kind;

namespace {

constexpr const char* kFunctions[] = {
#define BOUNCE_NAME(number, function) "bounce::" #function,
    BOUNCE_FUNCTIONS(BOUNCE_NAME)};

// A random number, so that no program can write an answer before it has the question.
std::uint64_t unforeseeable_number() {
  static std::random_device random;
  return std::uniform_int_distribution<std::uint64_t>()(random);
}

// More than any correct program needs; stops a program that calls back in an endless loop.
std::int64_t most_callbacks(const Frame& question) { return 1000 + 20 * question.T; }

// The solution's reply to a callback. Kind::threw, with the text, if it refuses the arguments.
Frame reply_to(const Frame& callback) {
  Frame reply;
  reply.kind = Kind::answer;
  reply.part = callback.part;
  reply.number = callback.number;
  try {
#define BOUNCE_REPLY(number, function) \
  if (callback.part == (number)) frames::answer(callback, reply, function);
    BOUNCE_FUNCTIONS(BOUNCE_REPLY)
  } catch (const std::exception& refused) {
    reply.kind = Kind::threw;
    frames::put_text(reply, refused.what());
  }
  return reply;
}

// With a step come those that follow it, until one is refused: a trajectory asks for them next.
Frame reply_ahead(Frame callback) {
  Frame reply = reply_to(callback);
  if (callback.part != 3) return reply;
  for (Frame next = reply; next.kind == Kind::answer && reply.T < frames::kStates; ++reply.T) {
    std::copy_n(next.values, frames::kState, callback.values);
    std::copy_n(next.values, frames::kState, reply.values + frames::kState * reply.T);
    next = reply_to(callback);
  }
  return reply;
}

}  // namespace

Session::Session(const std::vector<std::string>& command, Limits limits, std::uint32_t part,
                 bool given)
    : Session(
          [command](const Limits& now) { return std::make_unique<RunnerProcess>(command, now); },
          limits, part, given, unforeseeable_number) {}

Session::Session(Start start, Limits limits, std::uint32_t part, bool given, Numbers numbers)
    : start_(std::move(start)),
      limits_(limits),
      part_(part),
      given_(given),
      numbers_(std::move(numbers)),
      hangs_left_(given ? 1 : 2),
      last_question_(Clock::now() + std::chrono::seconds(limits.session_seconds)) {}

nlohmann::json facts_of(const Termination& end) {
  return {{"what", end.what}, {"number", end.number}, {"text", end.text}};
}

std::optional<Termination> Session::take_end() { return std::exchange(end_, std::nullopt); }

Frame Session::ask(const Frame& asked, Trajectory* columns) {
  Frame question = asked;
  if (!kit_failure_.empty()) throw tests::Ended{kit_failure_};
  if (is_earlier(question.part)) return right_answer(question);
  if (const char* why = why_not_asked()) {
    end_ = Termination{.status = "no_answer", .what = why, .of_no_case = true};
    throw tests::Ended{why};
  }
  Frame answer;
  try {
    if (!runner_) runner_ = start_(limits_);
    question.number = numbers_();
    answer = answer_of(question, columns);
  } catch (const KitFailure& failure) {
    kit_failure_ = failure.what();
    throw tests::Ended{kit_failure_};
  } catch (const Termination& end) {
    end_runner(end);
    throw tests::Ended{end.what};
  }
  if (answer.kind == Kind::threw) {
    const std::string text = frames::text(answer);
    throw std::runtime_error(
        submission::threw(question.part, text == frames::kNoException ? "" : text));
  }
  return answer;
}

Frame Session::right_answer(const Frame& question) {
  const Frame reply = reply_to(question);
  if (reply.kind == Kind::threw) throw std::runtime_error(frames::text(reply));
  return reply;
}

const char* Session::why_not_asked() const {
  if (hangs_left_ <= 0) return "not asked as it hung";
  const bool late = Clock::now() > last_question_ || cpu_seconds_ > limits_.session_cpu_seconds;
  return late ? "not asked for want of time" : nullptr;
}

void Session::end_runner(const Termination& end) {
  end_ = end;
  if (end.status == "timed_out") --hangs_left_;
  if (end.waits) hangs_left_ = 0;
  cpu_seconds_ += runner_->spent();
  limits_.wall_seconds = std::max(0.0, limits_.wall_seconds - runner_->waited().count());
  runner_.reset();
}

Frame Session::answer_of(const Frame& question, Trajectory* columns) {
  runner_->send(question);
  Frame answer = runner_->receive();
  for (int callbacks = 0; answer.kind == Kind::callback; ++callbacks) {
    if (!given_ || !is_earlier(answer.part)) throw Termination{"no_answer", "asked"};
    if (callbacks > most_callbacks(question)) {
      throw Termination{"timed_out", "called earlier parts", callbacks};
    }
    has_asked_given_ = has_asked_given_ || answer.part + 1 == part_;
    runner_->send(reply_ahead(answer));
    answer = runner_->receive();
  }
  if (answer.kind == Kind::absent) {
    const char* function = kFunctions[part_ - 1];
    throw Termination{
        .status = "does_not_compile", .what = "absent", .text = function, .of_no_case = true};
  }
  if (answer.kind == Kind::out_of_memory) throw out_of_memory(limits_);
  const bool known = answer.kind == Kind::answer || answer.kind == Kind::threw;
  if (!known || answer.number != question.number || answer.part != question.part) {
    throw Termination{"no_answer", "wrote no answer"};
  }
  if (columns && answer.kind == Kind::answer) {
    const Eigen::Index size = submission::columns_at_hand(answer.q_columns, answer.v_columns,
                                                          static_cast<int>(question.T));
    *columns = {Eigen::Matrix3Xd(3, size), Eigen::Matrix3Xd(3, size)};
    runner_->receive(columns->q);
    runner_->receive(columns->v);
  }
  return answer;
}

}  // namespace bounce::judge
