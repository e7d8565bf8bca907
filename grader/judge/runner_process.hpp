// A runner in another process: started, asked, watched and ended. Everything that comes from it
// is untrusted; what it prints is drained, counted and cut, and never read as an answer.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "../runner/frame.hpp"
#include "limits.hpp"
#include "process_usage.hpp"
#include "termination.hpp"

namespace bounce::judge {

// A runner can't go on.
struct RunnerEnded : std::runtime_error {
  explicit RunnerEnded(Termination termination_, bool waits_ = false)
      : std::runtime_error(termination_.sentence),
        termination(std::move(termination_)),
        waits(waits_) {}
  Termination termination;
  bool waits;  // it would do so the next time, too: no more is asked of this part
};

inline constexpr char kNotAskedFor[] =
    "the program wrote to where answers go (descriptor 4, which is the kit's), and what came isn't "
    "the answer that was asked for";

// The box that a runner was to be in couldn't be made: a failure of the kit.
struct NoBox : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Keeps this process, and the runners it starts, on the CPU it is on. Judge and runner only ever
// take turns, and waking each other on one CPU takes a fifth of the time that it takes across two.
void stay_on_this_cpu();

class RunnerProcess {
 public:
  // Starts `command` with the questions on descriptor 3 and the answers on 4; a box, with 5 to tell
  // when it is made. Throws std::runtime_error when it can't be started, and later NoBox when its
  // box can't be made: failures of the kit.
  RunnerProcess(const std::vector<std::string>& command, const Limits& limits);
  // Somebody else's pipes, which this closes in the end, and no process: answers may be there
  // before they are asked for.
  RunnerProcess(int questions, int answers, int prints, const Limits& limits);
  ~RunnerProcess();
  RunnerProcess(const RunnerProcess&) = delete;
  RunnerProcess& operator=(const RunnerProcess&) = delete;

  // Throw RunnerEnded when the runner has ended, hangs, floods or doesn't keep to the frames.
  void send(const frames::Frame& frame);
  frames::Frame receive();
  void receive(Eigen::Matrix3Xd& columns);

  // What it has used so far, and nobody can tell us otherwise: CPU time as the system counts it.
  // Throws std::runtime_error where the system doesn't.
  double cpu_ns() const;

  // What it had used in all when it ended, s of CPU time; 0 while it is at work.
  double spent() const { return spent_; }

  // How long it waited for anything but a CPU, where it should have answered.
  std::chrono::duration<double> idle() const { return idle_; }

 private:
  using Clock = std::chrono::steady_clock;

  void set_up();
  void read_exactly(void* data, std::size_t size, bool amid_an_answer);
  bool wait_until_readable(bool amid_an_answer);
  void drain_prints();
  void hear_the_box();
  bool box_is_made();
  void require_a_box();
  void count_idle_time(const ProcessUsage& seen);
  void end_if_it_hangs(bool amid_an_answer);
  void end_if_late(bool amid_an_answer);
  [[noreturn]] void end_without_answer(bool amid_an_answer, const std::string& why);
  [[noreturn]] void end_after_close(const std::string& closed);
  [[noreturn]] void end(const Termination& termination, bool waits = false);
  void close_prints();
  int wait_for_exit();
  void kill();
  void forget();

  Limits limits_;
  pid_t pid_ = -1;
  int questions_ = -1, answers_ = -1, prints_ = -1;
  int status_ = -1;   // what the box tells: enter.cpp
  std::string told_;  // by the box
  std::size_t printed_ = 0;
  std::string last_print_;  // the end of what was printed: an assertion's text is there
  Clock::duration waited_{};
  std::chrono::duration<double> idle_{}, idle_before_{};
  bool counts_idle_ = false;
  double spent_ = 0;
  Clock::time_point last_look_;
};

}  // namespace bounce::judge
