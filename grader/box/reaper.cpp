#include "reaper.hpp"

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <string>

#include "require.hpp"

namespace bounce::box {
namespace {

void kill_all_children() {
  const std::string self = std::to_string(::getpid());
  std::ifstream children("/proc/self/task/" + self + "/children");
  for (pid_t child = 0; children >> child;) ::kill(child, SIGKILL);
}

// Orphans become children of this process, which is their subreaper. One that starts others
// faster than they are found is stopped by the limit on processes.
void end_what_is_left() {
  while (true) {
    kill_all_children();
    if (::waitpid(-1, nullptr, 0) < 0) return;
  }
}

volatile std::sig_atomic_t asked_to_end = 0;

// Whoever started the box is impatient, or has died: what follows still dies, and what was made is
// taken away.
void hear_when_to_end() {
  struct sigaction action = {};
  action.sa_handler = [](int) { asked_to_end = 1; };  // no SA_RESTART: it ends waitpid
  require(::sigaction(SIGTERM, &action, nullptr), "hearing when to end");
  require(::prctl(PR_SET_PDEATHSIG, SIGTERM), "ending with who started it");
}

int end_of(pid_t child) {
  int status = 0;
  pid_t ended = 0;
  while ((ended = ::waitpid(-1, &status, 0)) != child) {
    if (asked_to_end) return 128 + SIGTERM;
    if (ended < 0 && errno != EINTR) return 1;
  }
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

}  // namespace

void guard_what_follows(void (*afterwards)()) {
  require(::prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0), "becoming the reaper");
  const pid_t child = require(::fork(), "starting a process");
  if (child == 0) return;
  hear_when_to_end();
  // Of what is open, nothing is kept: a pipe is closed when the child closes it.
  ::close_range(0, ~0U, 0);
  const int status = end_of(child);
  if (::getpid() != 1) end_what_is_left();  // else the namespace ends with this process
  afterwards();
  ::_exit(status);
}

}  // namespace bounce::box
