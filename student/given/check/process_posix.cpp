#include <fcntl.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <iostream>

#include "files.hpp"
#include "process.hpp"

namespace bounce::check {
namespace {

constexpr rlim_t kMemory = rlim_t{4} << 30;  // bytes
constexpr int kNotStarted = 127;

void limit(int what, rlim_t most, rlim_t further = 0) {
  const rlimit both{most, most + further};
  (void)::setrlimit(what, &both);  // one that the system doesn't know is left out
}

}  // namespace

std::optional<int> run(const std::vector<std::string>& command, const std::filesystem::path& output,
                       Limits limits) {
  std::vector<char*> words;
  words.reserve(command.size() + 1);
  for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  const std::string file = output.string();
  const pid_t child = ::fork();
  if (child < 0) throw Failure("the system starts no further program: close some, and try again");
  if (child == 0) {
    const int in = ::open("/dev/null", O_RDONLY);
    const int out = ::open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
    if (in < 0 || out < 0) ::_exit(kNotStarted);
    ::dup2(in, STDIN_FILENO);
    ::dup2(out, STDOUT_FILENO);
    ::dup2(out, STDERR_FILENO);
    limit(RLIMIT_CORE, 0);
    if (limits == Limits::of_a_part) {
      limit(RLIMIT_CPU, kSecondsOfWork, 1);  // the second kills
      limit(RLIMIT_FSIZE, kLargestFile);
      limit(RLIMIT_AS, kMemory);
    }
    ::execvp(words[0], words.data());
    ::_exit(kNotStarted);
  }
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFSIGNALED(status)) return -WTERMSIG(status);
  if (WEXITSTATUS(status) == kNotStarted) return std::nullopt;
  return WEXITSTATUS(status);
}

std::shared_ptr<void> lock(const std::filesystem::path& file) {
  const int handle = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
  if (handle < 0) throw Failure(kReadOnly);
  if (::flock(handle, LOCK_EX | LOCK_NB) != 0) {
    std::cerr << kWaits << std::endl;
    while (::flock(handle, LOCK_EX) != 0 && errno == EINTR) {
    }
  }
  return {nullptr, [handle](void*) { ::close(handle); }};
}

bool is_terminal() { return ::isatty(STDOUT_FILENO) == 1; }

}  // namespace bounce::check
