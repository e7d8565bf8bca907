// Fuzzes the reader of a runner's frames: the result is an answer to the question, or a status and
// one line. A runner that may not call given parts gets no answers from them.
//
// An input: the part, whether earlier parts are given, T, how much of the rest is printed, and
// then what is printed and what is sent.
#include <fcntl.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cmath>

#include "../../../grader/judge/session.hpp"
#include "../../../grader/runner/messages.hpp"
#include "../../parts/checks.hpp"
#include "fuzz.hpp"

namespace bounce::fuzz {
namespace {

using frames::Frame;
using frames::Kind;

constexpr std::size_t kHead = 4;
constexpr std::size_t kMostBytes = 32 * 1024;  // half of what a pipe holds

struct Input {
  std::uint32_t part;
  bool given;
  int T;
  std::string prints, sent;
};

Input input_of(const std::uint8_t* data, std::size_t size) {
  Input input{1 + data[0] % 4U, data[1] % 2 == 1, 1 + data[2] % 16, "", ""};
  const std::string rest(reinterpret_cast<const char*>(data) + kHead, size - kHead);
  const std::size_t printed = std::min<std::size_t>(data[3] * std::size_t{8}, rest.size());
  input.prints = rest.substr(0, printed);
  input.sent = rest.substr(printed, kMostBytes);
  return input;
}

// The reading end of a pipe that holds these bytes and then ends.
int holding(const std::string& bytes) {
  int ends[2];
  require(::pipe2(ends, O_CLOEXEC) == 0);
  require(::write(ends[1], bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size()));
  ::close(ends[1]);
  return ends[0];
}

// Whether the runner can be asked more.
bool ask(judge::Session& session, const Input& input) {
  Parameters params;
  params.T = input.T;
  Trajectory columns;
  try {
    const Frame answer =
        session.ask(frames::question(input.part, params, Vector3(0, 1, 0.5), Vector3(0, -1, 0)),
                    input.part == 4 ? &columns : nullptr);
    require(answer.kind == Kind::answer && answer.part == input.part);
    const Eigen::Index n = columns.q.cols();
    require(input.part != 4 || ((n == input.T || n == input.T - 1) && n >= 1));
    require(input.part != 4 || columns.v.cols() == n);
  } catch (const tests::Ended& ended) {
    const auto end = session.take_end();
    require(is_one_line(ended.why) && end && !end->status.empty());
    return false;
  } catch (const std::runtime_error& no_answer) {
    require(is_one_line(no_answer.what()) && !session.take_end());
  }
  return true;
}

std::string bytes_of(const Frame& frame) {
  return std::string(reinterpret_cast<const char*>(&frame), sizeof frame);
}

std::string seed(int part, bool given, const std::string& sent, const std::string& prints = "",
                 int T = 4) {
  const std::string padded = prints + std::string((8 - prints.size() % 8) % 8, ' ');
  const char head[kHead] = {static_cast<char>(part - 1), given, static_cast<char>(T - 1),
                            static_cast<char>(padded.size() / 8)};
  return std::string(head, kHead) + padded + sent;
}

Frame answer_of(std::uint32_t part, std::uint64_t number, Kind kind = Kind::answer) {
  Frame frame;
  frame.kind = kind;
  frame.part = part;
  frame.number = number;
  frame.q_columns = frame.v_columns = 4;
  for (double& value : frame.values) value = 0.25;
  return frame;
}

std::string callback_for(std::uint32_t part) {
  Frame callback = answer_of(part, 0, Kind::callback);
  double* values = callback.values;
  frames::put(callback, values, Parameters());
  return bytes_of(callback);
}

}  // namespace

std::vector<std::string> seeds() {
  const std::string columns(2 * 3 * 4 * sizeof(double), '\x11');
  Frame threw = answer_of(2, 1, Kind::threw);
  frames::put_text(threw, "not \x1b[2J yet\n");
  Frame nan = answer_of(2, 1);
  for (double& value : nan.values) value = NAN;
  return {
      seed(1, false, bytes_of(answer_of(1, 1)) + bytes_of(answer_of(1, 2))),
      seed(2, false, bytes_of(threw) + bytes_of(answer_of(2, 2)), "a print\n"),
      seed(2, false, bytes_of(nan) + bytes_of(answer_of(2, 2, Kind::out_of_memory))),
      seed(3, true,
           callback_for(1) + callback_for(2) + bytes_of(answer_of(3, 1)) + callback_for(3)),
      seed(3, false, callback_for(1) + bytes_of(answer_of(3, 1))),
      seed(4, true, callback_for(3) + bytes_of(answer_of(4, 1)) + columns),
      seed(4, false, bytes_of(answer_of(4, 1)) + columns + bytes_of(answer_of(4, 2)) + columns),
      seed(4, false, bytes_of(answer_of(4, 1)) + columns, "", 3),
      seed(4, false, bytes_of(answer_of(4, 1)) + columns, "", 5),
      seed(1, true, bytes_of(answer_of(1, 1, Kind::absent))),
  };
}

}  // namespace bounce::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace bounce;
  if (size < fuzz::kHead) return 0;
  const fuzz::Input input = fuzz::input_of(data, size);
  int questions[2];
  fuzz::require(::pipe2(questions, O_CLOEXEC) == 0);
  const auto start = [&](const judge::Limits& limits) {
    return std::make_unique<judge::RunnerProcess>(::dup(questions[1]), fuzz::holding(input.sent),
                                                  fuzz::holding(input.prints), limits);
  };
  int asked = 0;
  {
    std::uint64_t number = 0;
    judge::Session session(start, judge::Limits(), input.part, input.given,
                           [&number] { return ++number; });
    do {
      ++asked;
    } while (fuzz::ask(session, input) && asked < 3);
  }
  int told = 0;
  fuzz::require(::ioctl(questions[0], FIONREAD, &told) == 0);
  fuzz::require(input.given || told == asked * static_cast<int>(sizeof(frames::Frame)));
  for (const int fd : questions) ::close(fd);
  return 0;
}
