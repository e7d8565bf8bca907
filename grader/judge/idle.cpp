#include "idle.hpp"

#include <fstream>
#include <sstream>
#include <string>

namespace bounce::judge {
namespace {

std::string folder_of(pid_t pid) { return "/proc/" + std::to_string(pid); }

// Of /proc/PID/stat: the state, field 3, and utime and stime, fields 14 and 15. Field 2 is a name
// in parentheses, which may hold anything.
std::optional<long> ticks_if_it_waits(pid_t pid) {
  std::ifstream file(folder_of(pid) + "/stat");
  std::string line;
  std::getline(file, line);
  const std::size_t name_end = line.rfind(')');
  if (name_end == std::string::npos) return std::nullopt;
  std::istringstream fields(line.substr(name_end + 1));
  char state = 0;
  fields >> state;
  std::string skipped;
  for (int field = 4; field < 14; ++field) fields >> skipped;
  long utime = 0, stime = 0;
  fields >> utime >> stime;
  if (!fields || state == 'R' || state == 'D') return std::nullopt;
  return utime + stime;
}

}  // namespace

std::optional<long> ticks_if_all_wait(pid_t pid) {
  std::optional<long> ticks = ticks_if_it_waits(pid);
  std::ifstream children(folder_of(pid) + "/task/" + std::to_string(pid) + "/children");
  if (!children) return std::nullopt;
  for (pid_t child = 0; ticks && children >> child;) {
    const std::optional<long> more = ticks_if_all_wait(child);
    ticks = more ? std::optional<long>(*ticks + *more) : std::nullopt;
  }
  return ticks;
}

}  // namespace bounce::judge
