#include "orphans.hpp"

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <string>
#include <vector>

namespace bounce::judge {
namespace {

constexpr int kGenerations = 1000;  // an orphan's children are orphans next; a box has two

std::vector<pid_t> children() {
  const std::string self = std::to_string(::getpid());
  std::ifstream file("/proc/self/task/" + self + "/children");
  std::vector<pid_t> all;
  for (pid_t child = 0; file >> child;) all.push_back(child);
  return all;
}

}  // namespace

void adopt_orphans() { ::prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0); }

void end_orphans(const std::set<pid_t>& started) {
  for (int generation = 0; generation < kGenerations; ++generation) {
    bool any = false;
    for (const pid_t child : children()) {
      if (started.count(child) > 0) continue;
      any = true;
      ::kill(child, SIGKILL);
      ::waitpid(child, nullptr, 0);
    }
    if (!any) return;
  }
}

}  // namespace bounce::judge
