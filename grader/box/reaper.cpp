#include "steps.hpp"

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <string>

namespace bounce::box {
namespace {

// Whether this is the first process of a PID namespace: that ends with us, and kill(-1) reaches all
// of it.
bool has_its_own_space() { return ::getpid() == 1; }

void kill_all_children() {
  if (has_its_own_space()) {
    ::kill(-1, SIGKILL);
    return;
  }
  const std::string self = std::to_string(::getpid());
  std::ifstream children("/proc/self/task/" + self + "/children");
  for (pid_t child = 0; children >> child;) ::kill(child, SIGKILL);
}

// Kills all orphans: they become children of this process, their subreaper. The limit on processes
// stops one that starts others faster than they are killed.
void end_what_is_left() {
  while (true) {
    kill_all_children();
    if (::waitpid(-1, nullptr, 0) < 0) return;
  }
}

volatile std::sig_atomic_t asked_to_end = 0;

// Handles being told to end, because whoever started the box gave up or died: processes are still
// killed, and files removed. A PID namespace needs no handler; it ends with its first process.
void hear_when_to_end() {
  struct sigaction action = {};
  action.sa_handler = [](int) { asked_to_end = 1; };  // no SA_RESTART: interrupts waitpid
  require(::sigaction(SIGTERM, &action, nullptr), "hearing when to end");
  require(::prctl(PR_SET_PDEATHSIG, has_its_own_space() ? SIGKILL : SIGTERM),
          "ending with who started it");
}

int as_exit_status(int status) {
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

int end_of(pid_t child) {
  int status = 0;
  pid_t ended = 0;
  while ((ended = ::waitpid(-1, &status, 0)) != child) {
    if (asked_to_end) return 128 + SIGTERM;
    if (ended < 0 && errno != EINTR) return 1;
  }
  return as_exit_status(status);
}

void close_all_but(const std::vector<int>& kept) {
  int end = 0;
  for (const int fd : kept) end = std::max(end, fd + 1);
  ::close_range(static_cast<unsigned>(end), ~0U, 0);
  while (end-- > 0) {
    if (std::count(kept.begin(), kept.end(), end) == 0) ::close(end);
  }
}

}  // namespace

void guard_what_follows(const Guarding& guarding, const std::vector<int>& kept) {
  require(::prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0), "becoming the reaper");
  int ready[2];  // closed once the guard is ready
  require(::pipe(ready), "a pipe");
  const pid_t child = require(::fork(), "starting a process");
  if (child == 0) {
    ::close(ready[1]);
    char nothing = 0;
    require(::read(ready[0], &nothing, 1), "waiting for the guard");
    ::close(ready[0]);
    return;
  }
  hear_when_to_end();
  guarding.before();
  close_all_but(kept);  // also `ready`, and pipes, so that only the child keeps them open
  const int status = end_of(child);
  end_what_is_left();
  guarding.afterwards();
  ::_exit(status);
}

int status_of(char** command) {
  const pid_t child = require(::fork(), "starting a process");
  if (child == 0) {
    ::execvp(command[0], command);
    ::_exit(127);
  }
  int status = 0;
  require(::waitpid(child, &status, 0), "waiting for a process");
  const int exit_status = as_exit_status(status);
  return exit_status == 1 ? 3 : exit_status;
}

}  // namespace bounce::box
