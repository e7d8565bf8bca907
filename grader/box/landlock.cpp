#include "steps.hpp"

#include <fcntl.h>
#include <linux/landlock.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <iterator>

namespace bounce::box {
namespace {

// As in version 6 of Landlock; a distribution's header may declare only the first field.
struct Rules {
  std::uint64_t files = 0, connections = 0, scopes = 0;
};

// By version, from 1 on: how many rights to files it knows, from bit 0; how many bytes of Rules.
constexpr int kFileRights[] = {13, 14, 15, 15, 16, 16};
constexpr std::size_t kRulesSize[] = {8, 8, 8, 16, 16, 24};
constexpr std::uint64_t kConnections = 3;  // to bind to a port and to connect to one
constexpr std::uint64_t kScopes = 3;       // abstract sockets and signals
constexpr std::uint64_t kRead = LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR;
constexpr std::uint64_t kSee = kRead | LANDLOCK_ACCESS_FS_EXECUTE;
constexpr std::uint64_t kTruncate = 1 << 14;
constexpr std::uint64_t kOfOneFile = LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_WRITE_FILE |
                                     LANDLOCK_ACCESS_FS_READ_FILE | kTruncate;

void add(int ruleset, const std::string& path, std::uint64_t access) {
  const int fd = ::open(path.c_str(), O_PATH | O_CLOEXEC);
  if (fd < 0) return;  // a missing file needs no rule
  struct stat about = {};
  ::fstat(fd, &about);
  landlock_path_beneath_attr rule = {};
  rule.allowed_access = S_ISDIR(about.st_mode) ? access : access & kOfOneFile;
  rule.parent_fd = fd;
  require(::syscall(SYS_landlock_add_rule, ruleset, LANDLOCK_RULE_PATH_BENEATH, &rule, 0U),
          "a rule for " + path);
  ::close(fd);
}

}  // namespace

void see_only(const std::vector<std::string>& visible, const std::string& writable) {
  const long version = require(::syscall(SYS_landlock_create_ruleset, nullptr, 0, 1U), "Landlock");
  const long known = std::min<long>(version, std::ssize(kFileRights)) - 1;
  const std::uint64_t all = (std::uint64_t{1} << kFileRights[known]) - 1;
  const Rules rules{all, kConnections, kScopes};
  const auto ruleset = static_cast<int>(require(
      ::syscall(SYS_landlock_create_ruleset, &rules, kRulesSize[known], 0U), "Landlock's rules"));
  for (const std::string& path : visible) add(ruleset, path, kSee);
  if (!writable.empty()) add(ruleset, writable, all);
  add(ruleset, "/dev/null", (kRead | LANDLOCK_ACCESS_FS_WRITE_FILE | kTruncate) & all);
  require(::syscall(SYS_landlock_restrict_self, ruleset, 0U), "Landlock");
  ::close(ruleset);
}

}  // namespace bounce::box
