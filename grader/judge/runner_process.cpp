#include "runner_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <set>

#include "sentences.hpp"

namespace bounce::judge {
namespace {

constexpr std::size_t kKeptPrints = std::size_t{16} << 10;
constexpr std::chrono::milliseconds kBetweenLooks(100);  // between two checks of a silent runner
constexpr double kCpuGrace = 0.2;                        // s, for SIGXCPU to end a runner by itself
constexpr rlim_t kLargestFile = rlim_t{16} << 20;        // bytes, of what it writes without a box
constexpr int kLooks = 10;                               // to see whether a program sleeps
constexpr int kOrderlyTries = 200;                       // of 10 ms, to end a box from within
constexpr int kStatus = frames::kAnswers + 1;            // where a box reports that it is made
constexpr int kGenerations = 1000;  // an orphan's children are orphans next; a box has two

std::set<pid_t> started;  // the running runners

// The reading and the writing end.
std::array<int, 2> make_pipe() {
  std::array<int, 2> ends;
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw KitFailure("no pipe: out of descriptors");
  return ends;
}

void limit(int resource, rlim_t soft, rlim_t hard) {
  const rlimit both{soft, hard};
  ::setrlimit(static_cast<__rlimit_resource_t>(resource), &both);
}

// In the child: sets up descriptors 0 to 4 (for a box also 5) and no others, and the limits; then
// starts the command.
[[noreturn]] void become(const std::vector<std::string>& command, const Limits& limits,
                         std::array<int, 4> pipes) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  // First moves them away from 0 to 5, so that no dup2 overwrites a descriptor still needed.
  for (int& fd : pipes) fd = ::fcntl(fd, F_DUPFD, 10);
  const auto [questions, answers, prints, status] = pipes;
  const int nothing = ::open("/dev/null", O_RDWR);  // as grader/box/steps.hpp wants it
  ::dup2(nothing, 0);
  ::dup2(prints, 1);
  ::dup2(prints, 2);
  ::dup2(questions, frames::kQuestions);
  ::dup2(answers, frames::kAnswers);
  ::dup2(status, kStatus);
  ::close_range(limits.boxed ? kStatus + 1 : kStatus, ~0U, 0);

  const auto seconds = static_cast<rlim_t>(limits.cpu_seconds);
  limit(RLIMIT_CPU, seconds, seconds + 1);
  if (!limits.sanitized) limit(RLIMIT_AS, limits.memory, limits.memory);
  limit(RLIMIT_FSIZE, kLargestFile, kLargestFile);
  limit(RLIMIT_NOFILE, 64, 64);
  limit(RLIMIT_CORE, 1, 1);                      // as in enter.cpp
  std::vector<char*> words(command.size() + 1);  // the last is null
  std::transform(command.begin(), command.end(), words.begin(),
                 [](const std::string& word) { return const_cast<char*>(word.c_str()); });
  ::execv(words[0], words.data());
  ::_exit(127);
}

// The last of a chain of processes in which each has started the next, as in a box; `pid` itself if
// it has started none.
pid_t last_below(pid_t pid) {
  const std::vector<pid_t> children = children_of(pid);
  return children.empty() ? pid : last_below(children.front());
}

// Ends the children of this process that it hasn't started: they are orphans of its descendants. A
// box's processes end with its first one; but a box that is ended while it is set up can leave
// processes behind.
void end_orphans() {
  for (int generation = 0; generation < kGenerations; ++generation) {
    bool any = false;
    for (const pid_t child : children_of(::getpid())) {
      if (started.count(child) > 0) continue;
      any = true;
      ::kill(child, SIGKILL);
      ::waitpid(child, nullptr, 0);
    }
    if (!any) return;
  }
}

}  // namespace

void stay_on_this_cpu() {
  cpu_set_t cpus;
  CPU_ZERO(&cpus);
  CPU_SET(static_cast<std::size_t>(std::max(0, ::sched_getcpu())), &cpus);
  ::sched_setaffinity(0, sizeof cpus, &cpus);
}

RunnerProcess::RunnerProcess(const std::vector<std::string>& command, const Limits& limits)
    : RunnerProcess(-1, -1, -1, limits) {
  const auto questions = make_pipe(), answers = make_pipe(), prints = make_pipe(),
             status = make_pipe();
  ::prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0);  // orphans become children of this process
  pid_ = ::fork();
  if (pid_ < 0) throw KitFailure("no process could be started");
  const std::array<int, 4> theirs{questions[0], answers[1], prints[1], status[1]};
  if (pid_ == 0) become(command, limits, theirs);
  started.insert(pid_);
  for (const int fd : theirs) ::close(fd);
  questions_ = questions[1];
  answers_ = answers[0];
  prints_ = prints[0];
  status_ = status[0];
  // A runner that doesn't read must not block the judge.
  for (const int fd : {questions_, prints_, status_}) ::fcntl(fd, F_SETFL, O_NONBLOCK);
}

RunnerProcess::RunnerProcess(int questions, int answers, int prints, const Limits& limits)
    : limits_(limits), questions_(questions), answers_(answers), prints_(prints) {
  for (const int fd : {questions, prints}) ::fcntl(fd, F_SETFL, O_NONBLOCK);
}

RunnerProcess::~RunnerProcess() {
  kill();
  for (const int fd : {questions_, answers_, prints_, status_}) {
    if (fd >= 0) ::close(fd);
  }
}

void RunnerProcess::send(const frames::Frame& frame) {
  const ssize_t n = ::write(questions_, &frame, sizeof frame);
  if (n == static_cast<ssize_t>(sizeof frame)) return;
  if (errno == EAGAIN) end({"no_answer", "read no replies"});
  end_after_close("questions (descriptor 3)");
}

frames::Frame RunnerProcess::receive() {
  frames::Frame frame;
  read_exactly(&frame, sizeof frame, false);
  if (frame.magic != frames::kMagic) end({"no_answer", "wrote no answer"});
  return frame;
}

void RunnerProcess::receive(Eigen::Matrix3Xd& columns) {
  read_exactly(columns.data(), sizeof(double) * static_cast<std::size_t>(columns.size()), true);
}

double RunnerProcess::cpu_ns() const {
  const std::optional<ProcessUsage> usage = usage_of(pid_);
  if (!usage) throw KitFailure("this system doesn't tell the CPU time of a process");
  return usage->cpu_seconds * 1e9;
}

void RunnerProcess::read_exactly(void* data, std::size_t size, bool amid_an_answer) {
  char* to = static_cast<char*>(data);
  for (std::size_t got = 0; got < size;) {
    if (!wait_until_readable(amid_an_answer || got > 0)) continue;
    const ssize_t n = ::read(answers_, to + got, size - got);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) end_after_close("answers (descriptor 4)");
    got += static_cast<std::size_t>(n);
  }
}

// Waits for answers or printed text. It reads printed text at once, so that a runner never blocks
// on printing.
bool RunnerProcess::wait_until_readable(bool amid_an_answer) {
  if (Clock::now() - last_look_ >= kBetweenLooks) end_if_it_hangs(amid_an_answer);
  pollfd both[2] = {{answers_, POLLIN, 0}, {prints_, POLLIN, 0}};
  wait(both, 2, static_cast<int>(kBetweenLooks.count()));
  if (both[1].revents != 0) drain_prints();
  return both[0].revents != 0;
}

// A longer wait than was asked for isn't the program's: we were stopped, or had no CPU.
void RunnerProcess::wait(pollfd* descriptors, nfds_t count, int milliseconds) {
  const auto start = Clock::now();
  ::poll(descriptors, count, milliseconds);
  waited_ += std::min<Clock::duration>(Clock::now() - start, 2 * kBetweenLooks);
}

void RunnerProcess::drain_prints() {
  char chunk[65536];
  const ssize_t n = prints_ < 0 ? -1 : ::read(prints_, chunk, sizeof chunk);
  if (n == 0) {  // poll would report a closed pipe for ever, and ignores -1
    ::close(prints_);
    prints_ = -1;
  }
  if (n <= 0) return;
  printed_ += static_cast<std::size_t>(n);
  last_print_.append(chunk, static_cast<std::size_t>(n));
  if (last_print_.size() > kKeptPrints) last_print_.erase(0, last_print_.size() - kKeptPrints);
  if (printed_ >= limits_.prints) {
    end({"no_answer", "printed", static_cast<long>(limits_.prints >> 20)});
  }
}

// Reads the box's status: "m" when it is made, then "x" if the program can't be started.
void RunnerProcess::read_box_status() {
  char letters[2];
  const ssize_t n = status_ < 0 ? 0 : ::read(status_, letters, sizeof letters);
  if (n > 0) box_status_.append(letters, static_cast<std::size_t>(n));
}

bool RunnerProcess::box_is_made() {
  if (limits_.boxed && box_status_.empty()) read_box_status();
  return !limits_.boxed || box_status_.rfind('m', 0) == 0;
}

void RunnerProcess::require_a_box() {
  if (box_is_made()) return;
  drain_prints();
  kill();
  throw KitFailure("the box of a program couldn't be made: " + words::one_line(last_print_, 200));
}

// Ends a runner that ignores SIGXCPU, too; and one that sleeps where it should long have answered.
// One that works then is only slow, and has its CPU time.
void RunnerProcess::end_if_it_hangs(bool amid_an_answer) {
  last_look_ = Clock::now();
  if (pid_ < 0) return;
  const ProcessUsage seen = usage_of(pid_).value_or(ProcessUsage{});
  memory_ = std::max(memory_, seen.memory);
  if (seen.memory > limits_.memory) end(out_of_memory(limits_));
  if (seen.threads > limits_.threads) {
    end({"crashed", "threads", static_cast<long>(limits_.threads)});
  }
  if (seen.cpu_seconds > limits_.cpu_seconds + kCpuGrace) end(out_of_cpu_time(limits_, memory_));
  const bool hangs = waited() >= Seconds(limits_.wall_seconds) && box_is_made() && sleeps();
  if (!hangs && waited() < Seconds(limits_.busy_wall_seconds)) return;
  const char* came = amid_an_answer ? "a part of an answer" : "";
  if (hangs || amid_an_answer)
    end({"timed_out", seen.stopped ? "stopped" : "waited", 0, came}, true);
  require_a_box();
  kill();
  throw KitFailure("a program hardly ran: the machine was too busy");
}

// What woke us, such as a print, was written by a program at work. So it is looked at some times
// more; and it may have answered or ended since then.
bool RunnerProcess::sleeps() const {
  for (int look = 0; look < kLooks; ++look) {
    ::poll(nullptr, 0, 1);
    if (usage_of(pid_).value_or(ProcessUsage{}).works) continue;
    siginfo_t ended{};
    ::waitid(P_PID, static_cast<id_t>(pid_), &ended, WEXITED | WNOHANG | WNOWAIT);
    pollfd answers{answers_, POLLIN, 0};
    const bool has_answered = ::poll(&answers, 1, 0) > 0 && (answers.revents & POLLIN) != 0;
    return ended.si_pid == 0 && !has_answered;
  }
  return false;
}

// A pipe was closed: the program ended, or closed it itself.
void RunnerProcess::end_after_close(const char* closed) {
  const int status = wait_for_exit();
  if (status < 0) end({"no_answer", "closed", 0, closed}, true);
  drain_prints();
  require_a_box();
  read_box_status();
  if (box_status_ == "mx") throw Termination{"no_answer", "not started"};
  throw termination_of(status, limits_, last_print_, memory_);
}

void RunnerProcess::end(Termination termination, bool waits) {
  kill();
  termination.waits = waits;
  throw termination;
}

// The wait status, or -1 if it still runs after a while.
int RunnerProcess::wait_for_exit() {
  if (pid_ < 0) return 0;
  for (int tries = 0; tries < 1000; ++tries) {
    if (const std::optional<int> status = status_if_ended()) return *status;
    drain_prints();
    wait(nullptr, 0, 1);
    if (Clock::now() - last_look_ >= kBetweenLooks) end_if_it_hangs(false);
  }
  return -1;
}

// Once it has ended, also ends processes that it left.
std::optional<int> RunnerProcess::status_if_ended() {
  int status = 0;
  rusage usage = {};
  if (::wait4(pid_, &status, WNOHANG, &usage) != pid_) return std::nullopt;
  for (const timeval& time : {usage.ru_utime, usage.ru_stime}) {
    spent_ += static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  }
  memory_ = std::max(memory_, static_cast<std::size_t>(usage.ru_maxrss) << 10);
  started.erase(pid_);
  pid_ = -1;
  end_orphans();
  return status;
}

// Ends the program, and not its box, whose processes then wait for each other and end: the system
// counts CPU time only of a process that its parent waits for.
void RunnerProcess::kill() {
  if (pid_ < 0) return;
  const int ended = static_cast<int>(::syscall(SYS_pidfd_open, pid_, 0));
  for (int tries = 0; pid_ >= 0 && !status_if_ended(); ++tries) {
    const bool orderly = limits_.boxed && tries < kOrderlyTries;
    if (!orderly || ::kill(last_below(pid_), SIGKILL) != 0) ::kill(pid_, SIGKILL);
    pollfd end{ended, POLLIN, 0};
    ::poll(&end, 1, 10);
  }
  ::close(ended);
}

}  // namespace bounce::judge
