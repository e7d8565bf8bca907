#include "process_usage.hpp"

#include <sched.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace bounce::judge {
namespace {

std::string folder_of(pid_t pid) { return "/proc/" + std::to_string(pid); }

double seconds(double ticks) { return ticks / static_cast<double>(::sysconf(_SC_CLK_TCK)); }

struct Scheduled {
  double run = 0, delay = 0;  // s: CPU time; time ready to run while no CPU was free
};

// Reads the first two fields of a schedstat file, in ns. If the kernel doesn't count them, the
// thread is taken to wait for a CPU always.
Scheduled scheduled(const std::string& folder) {
  std::ifstream file(folder + "/schedstat");
  Scheduled ns;
  if (file >> ns.run >> ns.delay) return {ns.run * 1e-9, ns.delay * 1e-9};
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return {0, std::chrono::duration<double>(now).count()};
}

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
    const Scheduled thread = scheduled(task.path());
    ++threads;
    memory = std::max(memory, state.memory);
    all.ready = all.ready || state.letter == 'R';
    all.reads_a_disk = all.reads_a_disk || state.letter == 'D';
    all.delay_seconds += thread.delay;
    all.ended_seconds -= thread.run;
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
  all.ended_seconds += *cpu;
  add_threads(pid, all);  // after the clock, so that no running thread is taken for an ended one
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

// Field 8 of the first line of /proc/stat, of all CPUs together: at least what one has lost.
double own_delay_seconds() {
  std::ifstream file("/proc/stat");
  std::string stolen;
  for (int field = 0; field <= 8; ++field) file >> stolen;
  return scheduled("/proc/self").delay + seconds(std::atof(stolen.c_str()));
}

// Field 4 of the CPU's line in /proc/stat.
double spare_seconds() {
  const std::string name = "cpu" + std::to_string(::sched_getcpu());
  std::ifstream file("/proc/stat");
  std::string word;
  while (file >> word && word != name) continue;
  double user = 0, nice = 0, system = 0, spare = 0;
  file >> user >> nice >> system >> spare;
  return seconds(spare);
}

}  // namespace bounce::judge
