// enter run|check|build [--reduced] [--user N] [--in FOLDER] [--see PATH]... -- COMMAND...
//
// The last step into a box, taken inside of it: gives up privileges, sets the limits that count
// per user, installs the filter of system calls, and becomes COMMAND. With --reduced it makes the
// box by itself, without namespaces: Landlock hides all files but those beneath the PATHs, the
// environment is emptied, and what the command leaves behind is killed.
#include <fcntl.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "filter.hpp"
#include "landlock.hpp"
#include "privileges.hpp"
#include "reaper.hpp"
#include "require.hpp"

namespace bounce::box {
namespace {

struct Options {
  std::string kind;
  bool reduced = false;
  uid_t user = 65534;
  std::string folder;  // where the command starts; "" stays
  std::vector<std::string> visible;
  std::vector<std::string> command;
};

std::string scratch;  // of a reduced build box: its only folder to write to

Options parse(const std::vector<std::string>& words) {
  Options options;
  auto word = words.begin();
  if (word == words.end() || (*word != "run" && *word != "check" && *word != "build")) {
    throw std::runtime_error(
        "usage: enter run|check|build [OPTION]... -- COMMAND..., as in enter.cpp");
  }
  options.kind = *word++;
  for (; word != words.end() && *word != "--"; ++word) {
    if (*word == "--reduced") {
      options.reduced = true;
    } else if (*word == "--user" && word + 1 != words.end()) {
      options.user = static_cast<uid_t>(std::stoul(*++word));
    } else if (*word == "--in" && word + 1 != words.end()) {
      options.folder = *++word;
    } else if (*word == "--see" && word + 1 != words.end()) {
      options.visible.push_back(*++word);
    } else {
      throw std::runtime_error("unknown option " + *word);
    }
  }
  if (word != words.end()) options.command.assign(word + 1, words.end());
  if (options.command.empty()) throw std::runtime_error("no command is given after --");
  return options;
}

void limit(__rlimit_resource resource, rlim_t value) {
  rlimit now = {};
  require(::getrlimit(resource, &now), "reading a limit");
  now.rlim_max = std::min(now.rlim_max, value);
  now.rlim_cur = now.rlim_max;
  require(::setrlimit(resource, &now), "a limit");
}

// A user namespace of its own counts its processes by itself. It maps nobody, and gives no right.
void leave_the_common_user_namespace() { static_cast<void>(::unshare(CLONE_NEWUSER)); }

// After all changes of rights, each of which would undo it.
void die_with(pid_t guard) {
  require(::prctl(PR_SET_PDEATHSIG, SIGKILL), "dying with the box");
  if (::getppid() != guard) ::_exit(1);
}

void make_scratch(uid_t user) {
  char name[] = "/tmp/bounce-box-XXXXXX";
  if (!::mkdtemp(name)) throw std::runtime_error("no temporary folder can be made in /tmp");
  scratch = name;
  if (::geteuid() == 0) require(::chown(name, user, user), "giving away the temporary folder");
}

void remove_scratch() {
  std::error_code ignored;
  if (!scratch.empty()) std::filesystem::remove_all(scratch, ignored);
}

void close_what_was_inherited(bool build) {
  ::close_range(build ? 3 : 5, ~0U, 0);  // a runner has questions on 3 and answers on 4
}

void enclose(const Options& options) {
  const bool build = options.kind == "build";
  if (build) make_scratch(options.user);
  guard_what_follows(remove_scratch);
  see_only(options.visible, build ? std::vector{scratch} : std::vector<std::string>{});
  give_up_privileges(options.user);
}

// For a compiler, whose life is short: half of its time in the kernel goes into single pages.
const char* const kLargePages =
    "GLIBC_TUNABLES=glibc.malloc.hugetlb=1:glibc.malloc.top_pad=33554432";

[[noreturn]] void become(const Options& options) {
  std::vector<std::string> environment{"PATH=/usr/bin", kLargePages};
  if (!scratch.empty()) environment.push_back("TMPDIR=" + scratch);
  if (options.kind != "build") environment.clear();
  const auto pointers = [](const std::vector<std::string>& words) {
    std::vector<char*> all;
    for (const std::string& word : words) all.push_back(const_cast<char*>(word.c_str()));
    all.push_back(nullptr);
    return all;
  };
  const std::vector<char*> command = pointers(options.command), names = pointers(environment);
  ::execve(command[0], command.data(), names.data());
  throw std::runtime_error(options.command[0] + ": " + std::strerror(errno));
}

void enter(const Options& options) {
  const bool build = options.kind == "build";
  const pid_t guard = ::getpid();
  close_what_was_inherited(build);
  require(::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0), "no new privileges");
  if (options.reduced) {
    enclose(options);
  } else {
    if (build) guard_what_follows([] {});  // whose CPU time would be lost with the box
    give_up_privileges(options.user);
  }
  if (!options.folder.empty()) require(::chdir(options.folder.c_str()), options.folder);
  leave_the_common_user_namespace();
  if (options.reduced) die_with(guard);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_NPROC, build ? 128 : 1);
  limit(RLIMIT_NOFILE, build ? 256 : 16);
  if (build) refuse_what_no_compiler_needs();
  if (options.kind == "check") allow_what_checked_numbers_need();
  if (options.kind == "run") allow_only_what_numbers_need();
  become(options);
}

}  // namespace
}  // namespace bounce::box

int main(int argc, char** argv) try {
  bounce::box::enter(bounce::box::parse({argv + 1, argv + argc}));
} catch (const std::exception& e) {
  std::cerr << "enter: " << e.what() << "\n";
  return 125;
}
