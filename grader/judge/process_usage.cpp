#include "process_usage.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace bounce::judge {
namespace {

std::string folder_of(pid_t pid) { return "/proc/" + std::to_string(pid); }

struct State {
  char letter = 0;         // R, S, D, T ...; 0 if it is gone
  std::size_t memory = 0;  // resident bytes
};

// Fields 3 and 24 of a stat file. The name before them, in parentheses, may hold anything.
State state_of(const std::string& folder) {
  std::ifstream file(folder + "/stat");
  std::string line, skipped;
  std::getline(file, line, '\0');
  std::istringstream fields(line.substr(line.rfind(')') + 1));  // all of it where there is none
  State state;
  fields >> state.letter;
  for (int field = 4; field < 24; ++field) fields >> skipped;
  fields >> state.memory;
  state.memory *= static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
  return state;
}

// By the clock of its CPU time, s.
std::optional<double> cpu_seconds_of(pid_t pid) {
  clockid_t clock{};
  timespec time{};
  if (::clock_getcpuclockid(pid, &clock) != 0) return std::nullopt;
  if (::clock_gettime(clock, &time) != 0) return std::nullopt;
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9;
}

// Adds the threads of a process that haven't ended. The first may have ended before the others,
// and then doesn't know the memory.
void add_threads(pid_t pid, ProcessUsage& all) {
  std::size_t threads = 0, memory = 0;
  std::error_code gone;
  for (const auto& task : std::filesystem::directory_iterator(folder_of(pid) + "/task", gone)) {
    const State state = state_of(task.path());
    ++threads;
    memory = std::max(memory, state.memory);
    all.works = all.works || state.letter == 'R' || state.letter == 'D';
  }
  all.memory += memory;
  all.threads = std::max(all.threads, threads);
}

// Adds a process and its descendants. Returns whether the system reports the process.
bool add(pid_t pid, ProcessUsage& all) {
  const char state = state_of(folder_of(pid)).letter;
  const std::optional<double> cpu = cpu_seconds_of(pid);
  const std::vector<pid_t> children = children_of(pid);
  if (state == 0 || !cpu) return false;
  all.stopped = all.stopped || state == 'T' || state == 't';
  all.cpu_seconds += *cpu;
  add_threads(pid, all);
  for (const pid_t child : children) add(child, all);  // unless it has just ended
  return true;
}

// Field 4 of a stat file is the parent.
std::vector<pid_t> children_by_parent(pid_t pid) {
  std::vector<pid_t> children;
  std::error_code gone;
  for (const auto& process : std::filesystem::directory_iterator("/proc", gone)) {
    std::ifstream file(process.path() / "stat");
    std::string line;
    std::getline(file, line, '\0');
    std::istringstream fields(line.substr(line.rfind(')') + 1));
    char letter = 0;
    pid_t parent = 0;
    if (fields >> letter >> parent && parent == pid)
      children.push_back(std::atoi(process.path().filename().c_str()));
  }
  return children;
}

}  // namespace

std::optional<ProcessUsage> usage_of(pid_t pid) {
  ProcessUsage all;
  return add(pid, all) ? std::optional(all) : std::nullopt;
}

// Not every kernel lists them: then they are those of all processes whose parent it is.
std::vector<pid_t> children_of(pid_t pid) {
  std::ifstream file(folder_of(pid) + "/task/" + std::to_string(pid) + "/children");
  std::vector<pid_t> children;
  for (pid_t child = 0; file >> child;) children.push_back(child);
  return file.is_open() ? children : children_by_parent(pid);
}

}  // namespace bounce::judge
