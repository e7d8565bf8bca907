#include "glance.hpp"

#include <unistd.h>

#include <fstream>
#include <sstream>
#include <string>

namespace bounce::judge {
namespace {

std::string folder_of(pid_t pid) { return "/proc/" + std::to_string(pid); }

// Of /proc/PID/stat: the state, field 3, utime and stime, fields 14 and 15, and resident pages,
// field
// 24. Field 2 is a name in parentheses, which may hold anything.
std::optional<Glance> glance_at_one(pid_t pid) {
  std::ifstream file(folder_of(pid) + "/stat");
  std::string line;
  std::getline(file, line, '\0');
  const std::size_t name_end = line.rfind(')');
  if (name_end == std::string::npos) return std::nullopt;
  std::istringstream fields(line.substr(name_end + 1));
  char state = 0;
  fields >> state;
  std::string skipped;
  for (int field = 4; field < 14; ++field) fields >> skipped;
  double utime = 0, stime = 0;
  fields >> utime >> stime;
  for (int field = 16; field < 24; ++field) fields >> skipped;
  std::size_t pages = 0;
  fields >> pages;
  if (!fields) return std::nullopt;
  return Glance{state != 'R' && state != 'D', state == 'T' || state == 't',
                (utime + stime) / static_cast<double>(::sysconf(_SC_CLK_TCK)),
                pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE))};
}

}  // namespace

std::optional<Glance> glance_at(pid_t pid) {
  std::optional<Glance> all = glance_at_one(pid);
  std::ifstream children(folder_of(pid) + "/task/" + std::to_string(pid) + "/children");
  if (!children) return std::nullopt;
  for (pid_t child = 0; all && children >> child;) {
    const std::optional<Glance> more = glance_at(child);
    if (!more) continue;  // it has just ended
    all->waits = all->waits && more->waits;
    all->stopped = all->stopped || more->stopped;
    all->cpu_seconds += more->cpu_seconds;
    all->memory += more->memory;
  }
  return all;
}

}  // namespace bounce::judge
