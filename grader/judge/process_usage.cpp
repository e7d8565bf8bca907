#include "process_usage.hpp"

#include <sched.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace bounce::judge {
namespace {

std::string folder_of(pid_t pid) { return "/proc/" + std::to_string(pid); }

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

// Field 8 of the first line of /proc/stat, of all CPUs together: at least what one has lost.
double stolen_seconds() {
  std::ifstream file("/proc/stat");
  std::string skipped;
  for (int field = 0; field < 8; ++field) file >> skipped;
  double ticks = 0;
  file >> ticks;
  return ticks / static_cast<double>(::sysconf(_SC_CLK_TCK));
}

// What follows the name in a file such as /proc/PID/stat. The name, in parentheses, may hold
// anything.
std::istringstream fields_of(const std::string& path) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line, '\0');
  const std::size_t name_end = line.rfind(')');
  return std::istringstream(name_end == std::string::npos ? "" : line.substr(name_end + 1));
}

// By the clock of its CPU time, ns.
std::optional<double> cpu_ns_of_one(pid_t pid) {
  clockid_t clock{};
  timespec time{};
  if (::clock_getcpuclockid(pid, &clock) != 0) return std::nullopt;
  if (::clock_gettime(clock, &time) != 0) return std::nullopt;
  return static_cast<double>(time.tv_sec) * 1e9 + static_cast<double>(time.tv_nsec);
}

// Field 3 of a stat file; 0 if it is gone.
char state_of(const std::string& folder) {
  char state = 0;
  fields_of(folder + "/stat") >> state;
  return state;
}

// The resident bytes of a thread's process, by field 24 of its stat file; 0 if the thread has
// ended.
std::size_t memory_of(const std::string& folder) {
  std::istringstream fields = fields_of(folder + "/stat");
  std::string skipped;
  for (int field = 3; field < 24; ++field) fields >> skipped;
  std::size_t pages = 0;
  fields >> pages;
  return pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

// Adds up the threads that haven't ended. The first may have ended before the others.
void add_threads(pid_t pid, ProcessUsage& usage) {
  std::error_code gone;
  for (const auto& task : std::filesystem::directory_iterator(folder_of(pid) + "/task", gone)) {
    ++usage.threads;
    usage.ready = usage.ready || state_of(task.path()) == 'R';
    if (usage.memory == 0) usage.memory = memory_of(task.path());
    const Scheduled thread = scheduled(task.path());
    usage.delay_seconds += thread.delay;
    usage.ended_seconds -= thread.run;
  }
}

std::optional<ProcessUsage> usage_of_one(pid_t pid) {
  const char state = state_of(folder_of(pid));
  ProcessUsage usage;
  usage.reads_a_disk = state == 'D';
  usage.stopped = state == 'T' || state == 't';
  const std::optional<double> ns = cpu_ns_of_one(pid);
  if (state == 0 || !ns) return std::nullopt;
  usage.cpu_seconds = usage.ended_seconds = *ns * 1e-9;
  add_threads(pid, usage);  // after the clock, so that no running thread is taken for an ended one
  return usage;
}

std::optional<std::vector<pid_t>> children_of(pid_t pid) {
  std::ifstream file(folder_of(pid) + "/task/" + std::to_string(pid) + "/children");
  if (!file) return std::nullopt;
  std::vector<pid_t> children;
  for (pid_t child = 0; file >> child;) children.push_back(child);
  return children;
}

}  // namespace

std::optional<ProcessUsage> usage_of(pid_t pid) {
  std::optional<ProcessUsage> all = usage_of_one(pid);
  const auto children = children_of(pid);
  if (!all || !children) return std::nullopt;
  for (const pid_t child : *children) {
    const std::optional<ProcessUsage> more = usage_of(child);
    if (!more) continue;  // it has just ended
    all->reads_a_disk = all->reads_a_disk || more->reads_a_disk;
    all->stopped = all->stopped || more->stopped;
    all->ready = all->ready || more->ready;
    all->threads = std::max(all->threads, more->threads);
    all->cpu_seconds += more->cpu_seconds;
    all->delay_seconds += more->delay_seconds;
    all->ended_seconds += more->ended_seconds;
    all->memory += more->memory;
  }
  return all;
}

pid_t last_below(pid_t pid) {
  const auto children = children_of(pid);
  return children && !children->empty() ? last_below(children->front()) : pid;
}

double own_delay_seconds() { return scheduled("/proc/self").delay + stolen_seconds(); }

// Field 4 of each CPU's line in /proc/stat, ticks.
double spare_seconds() {
  cpu_set_t ours;
  CPU_ZERO(&ours);
  ::sched_getaffinity(0, sizeof ours, &ours);
  std::ifstream file("/proc/stat");
  double sum = 0;
  int count = 0;
  for (std::string line; std::getline(file, line) && line.rfind("cpu", 0) == 0;) {
    std::istringstream fields(line.substr(3));
    std::size_t cpu = 0;
    double user = 0, nice = 0, system = 0, spare = 0;
    const bool one = line[3] != ' ' && fields >> cpu >> user >> nice >> system >> spare;
    if (!one || cpu >= CPU_SETSIZE || !CPU_ISSET(cpu, &ours)) continue;
    sum += spare;
    ++count;
  }
  return sum / std::max(count, 1) / static_cast<double>(::sysconf(_SC_CLK_TCK));
}

std::optional<double> cpu_ns_of(pid_t pid) {
  std::optional<double> ns = cpu_ns_of_one(pid);
  const auto children = children_of(pid);
  if (!ns || !children) return std::nullopt;
  for (const pid_t child : *children) *ns += cpu_ns_of(child).value_or(0);
  return ns;
}

}  // namespace bounce::judge
