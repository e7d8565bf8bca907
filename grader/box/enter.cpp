// enter run|check|build [OPTION]... -- COMMAND...
// enter step COMMAND...
//
// Does the last steps into a box, from inside.
//
// Theory of operation. Of a run the judge, and of a build the kit, starts a box. In the full box it
// starts bubblewrap, which makes namespaces and mounts and becomes this program; a reduced box has
// none of that, and it starts this program itself. It forks. The parent is the guard: the box's
// first process, which no other process in the box can inspect, trace or signal. The child hides
// files (reduced box), gives up root, sets limits that count per user, installs the filter of
// system calls, and becomes COMMAND, with an environment of its own.
//
// Three pipes lead out of a run: questions come on descriptor 3 and answers go to 4, between the
// judge and COMMAND; and the status goes from here to the judge, which so knows whether the box or
// COMMAND failed. The guard waits for its child, kills what that leaves behind, passes out the file
// that a build has made, and ends with its child's status. The judge measures time from outside
// (judge/runner_process.cpp). If the judge or the kit ends, so does the box.
//
//   --box reduced  makes the box without namespaces: Landlock hides all files but those beneath
//                  the PATHs, and processes that the command leaves behind are killed
//   --box none     makes no box at all, for a command that is trusted
//   --user N       the user that the command runs as, if this is started as root
//   --status N     a descriptor of the kit, which COMMAND doesn't get: "m" is written to it when
//                  the box is made, just before COMMAND begins, "x" if COMMAND can't begin, and "s"
//                  if the file that it has made is longer than what could be written to --output
//   --output N     likewise; the file that COMMAND has made at OUTPUT is written to it
//   --in FOLDER    where COMMAND starts
//   --see PATH     what may be read and executed in a reduced box
//
// A build's COMMAND may write to one temporary folder. The word OUTPUT in it stands for a file
// there.
//
// step is for g++ -wrapper: it runs COMMAND, and exits with status 3 where COMMAND exits with 1,
// and 128 + n if a signal n ends it. g++ passes these on (-pass-exit-codes), and exits with 1 only
// where it can't start a program.
#include <fcntl.h>
#include <grp.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/sendfile.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "steps.hpp"

namespace bounce::box {
namespace {

// What a box may start above what its user has when it begins: processes, of which a thread counts
// as one. So few that it takes none that another box of the same user needs.
constexpr rlim_t kTasks = 128;

struct Options {
  std::string kind, box = "full";
  uid_t user = 65534;
  std::string folder;  // where the command starts; "": the current folder
  std::vector<std::string> visible, command;
};

// Global, because a signal handler and the guard read them, too.
std::string scratch;  // the only folder that a build may write to
bool scratch_is_ours = false;
int status = -1, output = -1;

Options parse(const std::vector<std::string>& words) {
  const auto end = std::find(words.begin(), words.end(), "--");
  if (words.end() - end < 2 || (end - words.begin()) % 2 == 0) {
    throw std::runtime_error("usage: enter run|check|build [OPTION VALUE]... -- COMMAND...");
  }
  Options options;
  options.kind = words[0];
  for (auto word = words.begin() + 1; word != end; word += 2) {
    const std::string &name = word[0], &value = word[1];
    if (name == "--box") options.box = value;
    if (name == "--user") options.user = static_cast<uid_t>(std::stoul(value));
    if (name == "--status") status = std::stoi(value);
    if (name == "--output") output = std::stoi(value);
    if (name == "--in") options.folder = value;
    if (name == "--see") options.visible.push_back(value);
  }
  options.command.assign(end + 1, words.end());
  return options;
}

void limit(__rlimit_resource resource, rlim_t value) {
  rlimit now = {};
  require(::getrlimit(resource, &now), "reading a limit");
  now.rlim_max = std::min(now.rlim_max, value);
  now.rlim_cur = now.rlim_max;
  require(::setrlimit(resource, &now), "a limit");
}

// How many processes and threads a user has.
rlim_t tasks_of(uid_t user) {
  rlim_t tasks = 0;
  std::error_code gone;
  for (const auto& process : std::filesystem::directory_iterator("/proc", gone)) {
    struct stat about = {};
    const std::string folder = process.path().string() + "/task";
    if (::stat(folder.c_str(), &about) != 0 || about.st_uid != user) continue;
    tasks += about.st_nlink - 2;  // a folder for each
  }
  return tasks;
}

// To be called after all changes of privileges, each of which would undo it.
void die_with(pid_t guard) {
  require(::prctl(PR_SET_PDEATHSIG, SIGKILL), "dying with the box");
  if (::getppid() != guard) ::_exit(1);
}

// In the full box, /tmp is the box's own.
void make_scratch(const Options& options) {
  scratch = "/tmp";
  if (options.box == "full") return;
  char name[] = "/tmp/bounce-box-XXXXXX";
  if (!::mkdtemp(name)) throw std::runtime_error("no temporary folder can be made in /tmp");
  scratch = name;
  scratch_is_ours = true;
  if (::geteuid() == 0 && options.box == "reduced") {
    require(::chown(name, options.user, options.user), "giving away the temporary folder");
  }
}

std::string made() { return scratch + "/output"; }

void tell(char what) {
  if (status >= 0) [[maybe_unused]]
    const auto written = ::write(status, &what, 1);
}

// Passes out the file that was made, but only if it is a regular file. Returns whether all of it
// could be written, which a full disk prevents.
bool hand_out() {
  struct stat about = {};
  if (output < 0) return true;
  const int from = ::open(made().c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK);
  if (from < 0) return errno != ENFILE && errno != ENOMEM && errno != EIO;
  if (::fstat(from, &about) != 0 || !S_ISREG(about.st_mode)) return true;
  for (off_t at = 0; at < about.st_size;) {
    if (::sendfile(output, from, &at, static_cast<std::size_t>(about.st_size - at)) <= 0)
      return false;
  }
  return true;
}

void hand_out_and_clean_up() {
  if (!hand_out()) tell('s');
  std::error_code ignored;
  if (scratch_is_ours) std::filesystem::remove_all(scratch, ignored);
}

// If run by root, becomes `user` for good.
void give_up_privileges(uid_t user) {
  if (::geteuid() != 0) return;
  require(::setgroups(0, nullptr), "leaving all groups");
  require(::setresgid(user, user, user), "changing the group");
  require(::setresuid(user, user, user), "changing the user");
  if (::setuid(0) == 0) throw std::runtime_error("root could be had again");
}

// /proc leads a compiler from a descriptor back to its pipe, which Landlock doesn't hide: an
// #include of its own messages would wait for them without end. Descriptors that are open stay of
// use.
void keep_pipes_from_being_opened_again() {
  for (const int fd : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    struct stat about = {};
    if (::fstat(fd, &about) != 0 || !S_ISFIFO(about.st_mode)) continue;
    require(::fchmod(fd, 0), "closing a pipe to others");
  }
}

[[noreturn]] void become(Options options) {
  std::vector<std::string> environment;
  if (options.kind == "build") {
    // Large pages: compilers spend half of their time in the kernel on mapping single ones.
    environment = {"PATH=/usr/bin", "TMPDIR=" + scratch,
                   "GLIBC_TUNABLES=glibc.malloc.hugetlb=1:glibc.malloc.top_pad=33554432"};
  }
  std::replace(options.command.begin(), options.command.end(), std::string("OUTPUT"), made());
  const auto pointers = [](const std::vector<std::string>& words) {
    std::vector<char*> all;
    for (const std::string& word : words) all.push_back(const_cast<char*>(word.c_str()));
    all.push_back(nullptr);
    return all;
  };
  const std::vector<char*> command = pointers(options.command), names = pointers(environment);
  tell('m');
  start(command.data(), names.data());
  throw std::runtime_error(options.command[0] + ": " + std::strerror(errno));
}

void limit_and_filter(const std::string& kind, rlim_t tasks) {
  const bool build = kind == "build";
  limit(RLIMIT_CORE, 1);  // with 0, a program that takes cores by a pipe would still be started
  limit(RLIMIT_NPROC, tasks);
  limit(RLIMIT_NOFILE, build ? 256 : 16);
  if (build) {
    forbid_non_compiler_calls();
  } else {
    restrict_to_submission_calls(kind == "check");
  }
}

void enter(const Options& options) {
  const bool boxed = options.box != "none", reduced = options.box == "reduced";
  const bool build = options.kind == "build";
  const pid_t guard = ::getpid();
  if (boxed) require(::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0), "no new privileges");
  require(::prctl(PR_SET_DUMPABLE, 0), "hiding this process");
  if (build) make_scratch(options);
  const Guarding guarding{boxed ? restrict_to_guard_calls : [] {}, hand_out_and_clean_up};
  // Of a run, the judge waits until every process has closed the status.
  guard_what_follows(guarding, build ? std::vector{status, output} : std::vector<int>{});
  // A runner has questions on 3 and answers on 4.
  ::close_range(build ? 3 : 5, ~0U, CLOSE_RANGE_CLOEXEC);
  const bool root = ::geteuid() == 0;
  // Before /proc is hidden; in the full box it is.
  rlim_t others = reduced ? tasks_of(root ? options.user : ::geteuid()) : 0;
  if (reduced) {
    keep_pipes_from_being_opened_again();
    see_only(options.visible, scratch);
  }
  if (boxed) give_up_privileges(options.user);
  // A new user namespace counts its tasks apart. It maps no user, and gives no rights.
  if (boxed && ::unshare(CLONE_NEWUSER) == 0) others = 0;
  if (!options.folder.empty()) require(::chdir(options.folder.c_str()), options.folder);
  if (reduced) die_with(guard);
  if (boxed) limit_and_filter(options.kind, others + kTasks);
  become(options);
}

}  // namespace
}  // namespace bounce::box

int main(int argc, char** argv) try {
  if (argc > 2 && std::string(argv[1]) == "step") return bounce::box::status_of(argv + 2);
  bounce::box::enter(bounce::box::parse({argv + 1, argv + argc}));
} catch (const std::exception& e) {
  std::cerr << "enter: " << e.what() << "\n";
  bounce::box::tell('x');
  return 125;
}
