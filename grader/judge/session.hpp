// Asks one submission the questions of one part's checks. If a runner ends, a new one is started
// for the next check, so that a crash costs one check. A part is asked no more if it hangs twice,
// if it waits for ever, or if it hangs once with given parts, which was its second chance.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "../../tests/parts/submission.hpp"
#include "runner_process.hpp"

namespace bounce::judge {

class Session : public submission::Asker {
 public:
  // given: answers callbacks for parts before `part` with the solution; otherwise answers none.
  Session(const std::vector<std::string>& command, Limits limits, std::uint32_t part, bool given);

  // For tests: another way to start runners and to number questions.
  using Start = std::function<std::unique_ptr<RunnerProcess>(const Limits& limits)>;
  using Numbers = std::function<std::uint64_t()>;
  Session(Start start, Limits limits, std::uint32_t part, bool given, Numbers numbers);

  // The answer to a question, the solution's if it is about an earlier part. Throws tests::Ended if
  // the check can't go on, and std::runtime_error if this question has no answer.
  frames::Frame ask(const frames::Frame& question, Trajectory* columns) override;

  frames::Frame right_answer(const frames::Frame& question) override;

  // Ends the program, which then can't measure what is done with its answers. Earlier parts can
  // still be asked, as the solution answers for them.
  void end() { runner_.reset(); }

  // Whether the program has called the given part before its own. One that never does has code of
  // its own for that, as in a helper that both share.
  bool has_asked_given() const { return has_asked_given_; }

  // CPU time of the current runner, ns; 0 if there is none.
  double cpu_ns() const { return runner_ ? runner_->cpu_ns() : 0; }

  // Why the kit has failed, in which case no verdict is valid; empty if it hasn't.
  const std::string& kit_failure() const { return kit_failure_; }

  // How the last check's runner ended, if it did. To be called once for each check.
  std::optional<Termination> take_end();

 private:
  bool is_earlier(std::uint32_t part) const { return part >= 1 && part < part_; }
  frames::Frame answer_of(const frames::Frame& question, Trajectory* columns);
  const char* why_not_asked() const;  // as a Termination's `what`, or null
  void end_runner(const Termination& end);

  using Clock = std::chrono::steady_clock;

  Start start_;
  Limits limits_;  // its wall_seconds are those that are left
  std::uint32_t part_;
  bool given_, has_asked_given_ = false;
  std::unique_ptr<RunnerProcess> runner_;
  Numbers numbers_;
  int hangs_left_;
  double cpu_seconds_ = 0;  // used by the runners that have ended
  Clock::time_point last_question_;
  std::optional<Termination> end_;
  std::string kit_failure_;
};

// {"what", "number", "text"}
nlohmann::json facts_of(const Termination& end);

}  // namespace bounce::judge
