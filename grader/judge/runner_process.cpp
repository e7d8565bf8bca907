#include "runner_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>

#include "ending.hpp"
#include "idle.hpp"

namespace bounce::judge {
namespace {

constexpr std::size_t kKeptPrints = 4096;
constexpr long kTicksOfWork = 3;  // what waking up now and then may take, in 1/100 s
constexpr int kGlance = 100;      // ms between two looks at whether a silent runner still works

struct Pipe {
  int read = -1, write = -1;
};

Pipe make_pipe() {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe: out of descriptors");
  return {ends[0], ends[1]};
}

void limit(int resource, rlim_t soft, rlim_t hard) {
  const rlimit both{soft, hard};
  ::setrlimit(static_cast<__rlimit_resource_t>(resource), &both);
}

// In the child: descriptors 0 to 4 and nothing else, limits, and then the command.
[[noreturn]] void become(const std::vector<char*>& argv, const Limits& limits, int questions,
                         int answers, int prints) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  // Out of the way of 0 to 4 first, so that no dup2 overwrites what the next one needs.
  questions = ::fcntl(questions, F_DUPFD, 10);
  answers = ::fcntl(answers, F_DUPFD, 10);
  prints = ::fcntl(prints, F_DUPFD, 10);
  const int nothing = ::open("/dev/null", O_RDONLY);
  ::dup2(nothing, 0);
  ::dup2(prints, 1);
  ::dup2(prints, 2);
  ::dup2(questions, frames::kQuestions);
  ::dup2(answers, frames::kAnswers);
  for (int fd = frames::kAnswers + 1; fd < 64; ++fd) ::close(fd);

  const auto seconds = static_cast<rlim_t>(limits.cpu_seconds);
  limit(RLIMIT_CPU, seconds, seconds + 1);
  limit(RLIMIT_AS, limits.memory, limits.memory);
  limit(RLIMIT_FSIZE, 0, 0);
  limit(RLIMIT_NOFILE, 64, 64);
  limit(RLIMIT_CORE, 0, 0);
  ::execv(argv[0], argv.data());
  ::_exit(127);
}

}  // namespace

void stay_on_this_cpu() {
  cpu_set_t cpus;
  CPU_ZERO(&cpus);
  CPU_SET(static_cast<std::size_t>(std::max(0, ::sched_getcpu())), &cpus);
  ::sched_setaffinity(0, sizeof cpus, &cpus);
}

RunnerProcess::RunnerProcess(const std::vector<std::string>& command, const Limits& limits)
    : limits_(limits) {
  std::vector<char*> argv(command.size() + 1, nullptr);
  std::transform(command.begin(), command.end(), argv.begin(),
                 [](const std::string& word) { return const_cast<char*>(word.c_str()); });

  const Pipe questions = make_pipe(), answers = make_pipe(), prints = make_pipe();
  pid_ = ::fork();
  if (pid_ < 0) throw std::runtime_error("no process could be started");
  if (pid_ == 0) become(argv, limits, questions.read, answers.write, prints.write);
  for (const int fd : {questions.read, answers.write, prints.write}) ::close(fd);
  questions_ = questions.write;
  answers_ = answers.read;
  prints_ = prints.read;
  set_up();
}

RunnerProcess::RunnerProcess(int questions, int answers, int prints, const Limits& limits)
    : limits_(limits), questions_(questions), answers_(answers), prints_(prints) {
  set_up();
}

void RunnerProcess::set_up() {
  ::fcntl(prints_, F_SETFL, O_NONBLOCK);
  ::fcntl(questions_, F_SETFL, O_NONBLOCK);
  start_the_clock();
}

RunnerProcess::~RunnerProcess() {
  kill();
  for (const int fd : {questions_, answers_, prints_}) {
    if (fd >= 0) ::close(fd);
  }
}

void RunnerProcess::start_the_clock() {
  last_change_ = Clock::now();
  deadline_ = last_change_ + std::chrono::seconds(limits_.wall_seconds);
}

void RunnerProcess::send(const frames::Frame& frame) {
  // A frame is smaller than PIPE_BUF: it is written whole or not at all. The pipe holds hundreds,
  // and who reads what it asks for has at most one under way.
  const ssize_t n = ::write(questions_, &frame, sizeof frame);
  if (n < 0 && errno == EAGAIN) {
    end("no_answer", "the program asks again and again without reading what it is told");
  }
  if (n != static_cast<ssize_t>(sizeof frame)) end_after_close();
}

frames::Frame RunnerProcess::receive() {
  frames::Frame frame;
  read_exactly(&frame, sizeof frame);
  if (frame.magic != frames::kMagic) {
    end("no_answer", "the program wrote something that isn't an answer to where answers go");
  }
  return frame;
}

void RunnerProcess::receive(Eigen::Matrix3Xd& columns) {
  read_exactly(columns.data(), sizeof(double) * static_cast<std::size_t>(columns.size()));
}

void RunnerProcess::read_exactly(void* data, std::size_t size) {
  char* to = static_cast<char*>(data);
  while (size > 0) {
    if (!wait_until_readable()) continue;
    const ssize_t n = ::read(answers_, to, size);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) end_after_close();
    to += n;
    size -= static_cast<std::size_t>(n);
  }
}

// Waits for answers or prints; prints are drained here, so that a runner never blocks on them.
bool RunnerProcess::wait_until_readable() {
  pollfd both[2] = {{answers_, POLLIN, 0}, {prints_, POLLIN, 0}};
  ::poll(both, 2, kGlance);
  if (both[1].revents != 0) drain_prints();
  if (both[0].revents != 0) {
    if (Clock::now() > deadline_) end_at_the_deadline();  // it may come byte by byte
    return true;
  }
  end_if_it_waits();
  return false;
}

void RunnerProcess::end_if_it_waits() {
  const auto now = Clock::now();
  if (now - last_look_ < std::chrono::milliseconds(kGlance)) return;
  last_look_ = now;
  const std::optional<long> ticks = ticks_if_all_wait(pid_);
  if (!ticks || !ticks_ || *ticks - *ticks_ > kTicksOfWork) {
    last_change_ = now;
    ticks_ = ticks;
  }
  if (now > deadline_) end_at_the_deadline();
  if (now - last_change_ >= std::chrono::seconds(limits_.idle_seconds)) {
    kill();
    throw RunnerEnded("timed_out",
                      "no answer came: the program waits for something, perhaps for input", true);
  }
}

void RunnerProcess::end_at_the_deadline() {
  kill();
  throw RunnerEnded("timed_out",
                    "no whole answer came in " + std::to_string(limits_.wall_seconds) + " s", true);
}

void RunnerProcess::drain_prints() {
  char chunk[65536];
  const ssize_t n = ::read(prints_, chunk, sizeof chunk);
  if (n <= 0) {
    if (n == 0) close_prints();  // a closed pipe would be readable for ever
    return;
  }
  printed_ += static_cast<std::size_t>(n);
  last_print_.append(chunk, static_cast<std::size_t>(n));
  if (last_print_.size() > kKeptPrints) last_print_.erase(0, last_print_.size() - kKeptPrints);
  if (printed_ >= limits_.prints) {
    end("no_answer", "the program printed more than " + std::to_string(limits_.prints >> 20) +
                         " MB and was stopped");
  }
}

void RunnerProcess::close_prints() {
  ::close(prints_);
  prints_ = -1;  // poll passes over it
}

// The answers were closed: by the program's end, or by the program itself.
void RunnerProcess::end_after_close() {
  const int status = wait_for_exit();
  if (status < 0) {
    kill();
    throw RunnerEnded("no_answer", "the program closed the pipe for its answers", true);
  }
  if (prints_ >= 0) drain_prints();
  const Ending ending = ending_of(status, limits_.cpu_seconds, last_print_);
  throw RunnerEnded(ending.status, ending.sentence, false, ending.stack);
}

void RunnerProcess::end(const std::string& status, const std::string& sentence) {
  kill();
  throw RunnerEnded(status, sentence);
}

// The wait status, or -1 when it still runs after a while.
int RunnerProcess::wait_for_exit() {
  if (pid_ < 0) return 0;
  for (int tries = 0; tries < 1000; ++tries) {
    int status = 0;
    if (::waitpid(pid_, &status, WNOHANG) == pid_) {
      pid_ = -1;
      return status;
    }
    ::poll(nullptr, 0, 1);
  }
  return -1;
}

void RunnerProcess::kill() {
  if (pid_ < 0) return;
  ::kill(pid_, SIGKILL);
  ::waitpid(pid_, nullptr, 0);
  pid_ = -1;
}

}  // namespace bounce::judge
