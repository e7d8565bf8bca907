// A runner in another process: started, asked, watched and ended. Everything that comes from it
// is untrusted; what it prints is drained and counted, and never read as an answer.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "../runner/frame.hpp"

namespace bounce::judge {

// How a part that can't go on ended: a status of the score record, and one plain sentence.
struct RunnerEnded : std::runtime_error {
  RunnerEnded(std::string status_, const std::string& sentence, bool waits_ = false,
              std::string stack_ = "")
      : std::runtime_error(sentence),
        status(std::move(status_)),
        waits(waits_),
        stack(std::move(stack_)) {}
  std::string status;
  bool waits;         // it would do so the next time, too: no more is asked of this part
  std::string stack;  // of a crash: addresses in hexadecimal
};

struct Limits {
  int cpu_seconds = 1;        // of a runner's life
  int idle_seconds = 1;       // of waiting, without a wish to run
  int wall_seconds = 60;      // of one question: lax, for a machine that is very busy
  int session_seconds = 200;  // of all questions of a part, so that the judge ends by itself
  std::size_t memory = std::size_t{1} << 30;
  std::size_t prints = std::size_t{8} << 20;  // bytes, over a runner's life
};

// Keeps this process, and the runners it starts, on the CPU it is on. Judge and runner only ever
// take turns, and waking each other on one CPU takes a fifth of the time that it takes across two.
void stay_on_this_cpu();

class RunnerProcess {
 public:
  // Starts `command` with the questions on descriptor 3 and the answers on 4.
  // Throws std::runtime_error when it can't be started: a failure of the kit.
  RunnerProcess(const std::vector<std::string>& command, const Limits& limits);
  // Somebody else's pipes, which this closes in the end, and no process.
  RunnerProcess(int questions, int answers, int prints, const Limits& limits);
  ~RunnerProcess();
  RunnerProcess(const RunnerProcess&) = delete;
  RunnerProcess& operator=(const RunnerProcess&) = delete;

  // Throw RunnerEnded when the runner has ended, hangs, floods or doesn't keep to the frames.
  void send(const frames::Frame& frame);
  frames::Frame receive();
  void receive(Eigen::Matrix3Xd& columns);

  // The clock of one question starts anew.
  void start_the_clock();

 private:
  using Clock = std::chrono::steady_clock;

  void set_up();
  void read_exactly(void* data, std::size_t size);
  bool wait_until_readable();
  void drain_prints();
  void end_if_it_waits();
  [[noreturn]] void end_after_close();
  [[noreturn]] void end(const std::string& status, const std::string& sentence);
  [[noreturn]] void end_at_the_deadline();
  void close_prints();
  int wait_for_exit();
  void kill();

  Limits limits_;
  pid_t pid_ = -1;
  int questions_ = -1, answers_ = -1, prints_ = -1;
  std::size_t printed_ = 0;
  std::string last_print_;  // the end of what was printed: an assertion's text is there
  Clock::time_point deadline_;
  Clock::time_point last_look_;
  Clock::time_point last_change_;  // when the runner was last seen to run, or to be ready to
  std::optional<long> ticks_;
};

}  // namespace bounce::judge
