// The questions of one part's checks to one submission. A runner that ended is started anew for
// the next check, so that a crash costs one check. A part that hangs twice is asked no more; nor is
// one that waits for ever, or that hangs once with the earlier parts given, its second chance.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "runner_process.hpp"

namespace bounce::judge {

class Session {
 public:
  // given: callbacks for parts before `part` are answered from the solution; else none is.
  Session(std::vector<std::string> command, Limits limits, std::uint32_t part, bool given);

  // With runners that are started, and questions that are numbered, in another way.
  using Start = std::function<std::unique_ptr<RunnerProcess>(const Limits& limits)>;
  using Numbers = std::function<std::uint64_t()>;
  Session(Start start, Limits limits, std::uint32_t part, bool given, Numbers numbers);

  // The answer to a question, and the columns of one of part 4, T or one less. Throws tests::Ended
  // when the check can't go on, std::runtime_error when this question has no answer.
  frames::Frame ask(frames::Frame question, Trajectory* columns = nullptr);

  // CPU time of the runner at work, ns; 0 where there is none.
  double cpu_ns() const { return runner_ ? runner_->cpu_ns() : 0; }

  // Why the kit has failed, or nothing: then no verdict holds.
  const std::string& kit_failure() const { return kit_failure_; }

  // How the last check's runner ended, if it did: a status, and a crash's stack. Once a check.
  struct End {
    std::string status, stack;
  };
  std::optional<End> take_end();

 private:
  frames::Frame answer_of(const frames::Frame& question, Trajectory* columns);
  void read_columns(const frames::Frame& question, const frames::Frame& answer, Trajectory& into);
  void require_time() const;
  void end_runner();

  using Clock = std::chrono::steady_clock;

  Start start_;
  Limits limits_;  // idle_seconds: what is left of them
  std::uint32_t part_;
  bool given_;
  std::unique_ptr<RunnerProcess> runner_;
  Numbers numbers_;
  int hangs_left_;
  double cpu_seconds_ = 0;  // of the runners that have ended
  Clock::time_point last_question_;
  std::optional<End> end_;
  std::string kit_failure_;
};

// The session that submission_remote.cpp asks; the judge's main sets it.
extern Session* session;

}  // namespace bounce::judge
