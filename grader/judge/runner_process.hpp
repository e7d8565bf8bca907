// Starts, asks, watches and ends a runner, which is another process. Everything that it sends is
// untrusted; printed text is counted and cut, and never read as an answer.
#pragma once

#include <poll.h>
#include <sys/types.h>

#include <chrono>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "../runner/frame.hpp"
#include "process_usage.hpp"
#include "termination.hpp"

namespace bounce::judge {

// A runner or its box couldn't be started, or the machine gave it no time: no fault of the
// submission's.
struct KitFailure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Pins this process and the runners it starts to the current CPU. Judge and runner take turns, and
// on one CPU they wake each other in a fifth of the time.
void stay_on_this_cpu();

class RunnerProcess {
  using Clock = std::chrono::steady_clock;
  using Seconds = std::chrono::duration<double>;

 public:
  // Starts `command` with the questions on descriptor 3 and the answers on 4; a box reports on 5
  // that it is made. Throws KitFailure if that can't be done, here or later.
  RunnerProcess(const std::vector<std::string>& command, const Limits& limits);
  // For tests: uses the given pipes, which it closes in the end, and starts no process. Answers may
  // be there before the questions.
  RunnerProcess(int questions, int answers, int prints, const Limits& limits);
  ~RunnerProcess();
  RunnerProcess(const RunnerProcess&) = delete;
  RunnerProcess& operator=(const RunnerProcess&) = delete;

  // Throw Termination if the runner has ended, hangs, floods or breaks the protocol.
  void send(const frames::Frame& frame);
  frames::Frame receive();
  void receive(Eigen::Matrix3Xd& columns);

  // The CPU time that it has used so far, counted by the system, so the runner can't falsify it.
  // Throws KitFailure if the system doesn't count it.
  double cpu_ns() const;

  // The CPU time that it had used when it ended, s; 0 while it runs.
  double spent() const { return spent_; }

  // How long it was waited for.
  Seconds waited() const { return waited_; }

 private:
  void read_exactly(void* data, std::size_t size, bool amid_an_answer);
  bool wait_until_readable(bool amid_an_answer);
  void drain_prints();
  void read_box_status();
  bool box_is_made();
  void require_a_box();
  void wait(pollfd* descriptors, nfds_t count, int milliseconds);
  void end_if_it_hangs(bool amid_an_answer);
  bool sleeps() const;
  [[noreturn]] void end_after_close(const char* closed);
  [[noreturn]] void end(Termination termination, bool waits = false);
  int wait_for_exit();
  std::optional<int> status_if_ended();
  void kill();

  Limits limits_;
  pid_t pid_ = -1;
  int questions_ = -1, answers_ = -1, prints_ = -1;
  int status_ = -1;         // descriptor of the box's status, as in enter.cpp
  std::string box_status_;  // what came of it so far
  std::size_t printed_ = 0;
  std::string last_print_;  // the end of the printed text, which holds an assertion's message
  Clock::duration waited_{};
  double spent_ = 0;
  std::size_t memory_ = 0;  // the most that was seen, bytes
  Clock::time_point last_look_;
};

}  // namespace bounce::judge
