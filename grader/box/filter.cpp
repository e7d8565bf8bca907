#include "steps.hpp"

#include <fcntl.h>
#include <linux/sched.h>
#include <seccomp.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/random.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cstdint>
#include <iterator>
#include <sstream>
#include <string>

namespace bounce::box {
namespace {

// Wraps a filter of libseccomp: each failure is an exception, and nothing leaks if one is thrown.
class Filter {
 public:
  explicit Filter(std::uint32_t otherwise) : context_(seccomp_init(otherwise)) {
    if (!context_) throw std::runtime_error("seccomp_init failed");
  }
  ~Filter() { seccomp_release(context_); }
  Filter(const Filter&) = delete;
  Filter& operator=(const Filter&) = delete;

  template <class... Argument>
  void rule(std::uint32_t action, int call, const Argument&... arguments) {
    require(seccomp_rule_add(context_, action, call, sizeof...(arguments), arguments...),
            "a rule of the filter");
  }
  // One for each of these names.
  void rules(std::uint32_t action, const std::string& calls) {
    std::istringstream names(calls);
    for (std::string name; names >> name;) {
      const int call = seccomp_syscall_resolve_name(name.c_str());
      if (call == __NR_SCMP_ERROR) throw std::runtime_error("libseccomp knows no call " + name);
      rule(action, call);
    }
  }
  void install() { require(seccomp_load(context_), "installing the filter"); }

 private:
  scmp_filter_ctx context_;
};

constexpr std::uint32_t no(int why) { return SCMP_ACT_ERRNO(static_cast<std::uint16_t>(why)); }

// What pthread_create asks of clone. A process has none of these flags, or adds others.
constexpr scmp_datum_t kThread = CLONE_VM | CLONE_FS | CLONE_FILES | CLONE_SYSVSEM | CLONE_SIGHAND |
                                 CLONE_THREAD | CLONE_SETTLS | CLONE_PARENT_SETTID |
                                 CLONE_CHILD_CLEARTID;

void allow_threads(Filter& filter) {
  filter.rule(SCMP_ACT_ALLOW, SCMP_SYS(clone), SCMP_A0(SCMP_CMP_EQ, kThread));
  // clone3 hides its flags from a filter; without it, the C library uses clone.
  filter.rule(no(ENOSYS), SCMP_SYS(clone3));
}

// What malloc, the threads and the sanitizers tell the system of their memory. Other advice fails
// as on a system that doesn't know it: some of it is about memory that processes share.
void allow_usual_advice(Filter& filter) {
  constexpr scmp_datum_t kUsual[] = {MADV_DONTNEED, MADV_FREE, MADV_HUGEPAGE, MADV_NOHUGEPAGE,
                                     MADV_DONTDUMP};
  constexpr scmp_datum_t kLast = *std::max_element(std::begin(kUsual), std::end(kUsual));
  for (scmp_datum_t advice = 0; advice <= kLast; ++advice) {
    const bool usual = std::find(std::begin(kUsual), std::end(kUsual), advice) != std::end(kUsual);
    filter.rule(usual ? SCMP_ACT_ALLOW : no(EINVAL), SCMP_SYS(madvise),
                SCMP_A2(SCMP_CMP_EQ, advice));
  }
  filter.rule(no(EINVAL), SCMP_SYS(madvise), SCMP_A2(SCMP_CMP_GT, kLast));
}

// The fourth argument of the one execve that a filter lets through. The kernel doesn't look at it,
// and no program in the box can know it.
std::uint64_t secret = 0;

// Any other fails before the kernel looks for its file, and so doesn't tell whether there is one.
void allow_one_start(Filter& filter) {
  require(::getrandom(&secret, sizeof secret, 0), "a random number");
  filter.rule(SCMP_ACT_ALLOW, SCMP_SYS(execve), SCMP_A3(SCMP_CMP_EQ, secret));
  filter.rule(no(ENOSYS), SCMP_SYS(execve), SCMP_A3(SCMP_CMP_NE, secret));
  filter.rule(no(ENOSYS), SCMP_SYS(execveat));
}

// TCGETS2, by which glibc asks from 2.42 on whether output is a terminal; its header defines it
// with a structure that can't be included beside sys/ioctl.h's.
constexpr scmp_datum_t kTcgets2 = 0x802C542A;

void allow_numbers(Filter& filter) {
  filter.rules(SCMP_ACT_ALLOW,
               "read write readv writev lseek brk munmap mremap mprotect rt_sigaction "
               "rt_sigprocmask rt_sigreturn sigaltstack futex getrandom nanosleep "
               "gettimeofday time clock_getres getrusage times sched_yield getuid geteuid "
               "getgid getegid getpid gettid arch_prctl set_robust_list set_tid_address "
               "rseq uname poll pause exit exit_group");
  // Clocks of the system, and its own. Those below zero belong to other processes.
  for (const int call : {SCMP_SYS(clock_gettime), SCMP_SYS(clock_nanosleep)}) {
    filter.rule(SCMP_ACT_ALLOW, call, SCMP_A0(SCMP_CMP_LE, INT_MAX));
    filter.rule(no(EINVAL), call, SCMP_A0(SCMP_CMP_GT, INT_MAX));
  }
  // What the whole machine does, and whether another process is there, a program in another box
  // could make into a signal. 0 stands for the program itself.
  filter.rule(no(EPERM), SCMP_SYS(sysinfo));
  filter.rule(SCMP_ACT_ALLOW, SCMP_SYS(sched_getaffinity), SCMP_A0(SCMP_CMP_EQ, 0));
  filter.rule(no(EPERM), SCMP_SYS(sched_getaffinity), SCMP_A0(SCMP_CMP_NE, 0));
  // Signals to itself (abort and raise), reading limits, and asking whether output is a terminal.
  const auto self = static_cast<scmp_datum_t>(::getpid());
  filter.rule(SCMP_ACT_ALLOW, SCMP_SYS(tgkill), SCMP_A0(SCMP_CMP_EQ, self));
  filter.rule(SCMP_ACT_ALLOW, SCMP_SYS(kill), SCMP_A0(SCMP_CMP_EQ, self));
  filter.rule(SCMP_ACT_ALLOW, SCMP_SYS(prlimit64), SCMP_A0(SCMP_CMP_EQ, 0),
              SCMP_A2(SCMP_CMP_EQ, 0));
  for (const scmp_datum_t asks : {scmp_datum_t{TCGETS}, kTcgets2}) {
    filter.rule(SCMP_ACT_ALLOW, SCMP_SYS(ioctl), SCMP_A1(SCMP_CMP_EQ, asks));
  }
  // Shared memory stays, and counts as nobody's, while one page of it is mapped.
  filter.rule(SCMP_ACT_ALLOW, SCMP_SYS(mmap), SCMP_A3(SCMP_CMP_MASKED_EQ, MAP_SHARED, 0));
  filter.rule(no(EPERM), SCMP_SYS(mmap), SCMP_A3(SCMP_CMP_MASKED_EQ, MAP_SHARED, MAP_SHARED));
  allow_threads(filter);
  allow_usual_advice(filter);
  allow_one_start(filter);
}

// What a program writes goes nowhere: the file that it makes is its standard input, /dev/null,
// which stays open, and the folder that it makes isn't there. `others` is for files that it only
// reads.
void write_to_nothing(Filter& filter, std::uint32_t others) {
  constexpr std::uint32_t kSaysZero = no(0);
  constexpr scmp_datum_t kMake = O_CREAT;
  filter.rule(kSaysZero, SCMP_SYS(open), SCMP_A1(SCMP_CMP_MASKED_EQ, kMake, kMake));
  filter.rule(others, SCMP_SYS(open), SCMP_A1(SCMP_CMP_MASKED_EQ, kMake, 0));
  filter.rule(kSaysZero, SCMP_SYS(openat), SCMP_A2(SCMP_CMP_MASKED_EQ, kMake, kMake));
  filter.rule(others, SCMP_SYS(openat), SCMP_A2(SCMP_CMP_MASKED_EQ, kMake, 0));
  filter.rules(kSaysZero, "creat mkdir mkdirat");
  filter.rule(kSaysZero, SCMP_SYS(close), SCMP_A0(SCMP_CMP_EQ, STDIN_FILENO));
  filter.rule(SCMP_ACT_ALLOW, SCMP_SYS(close), SCMP_A0(SCMP_CMP_GT, STDIN_FILENO));
  // What opening and closing a stream asks.
  for (const scmp_datum_t what : {F_GETFD, F_SETFD, F_GETFL}) {
    filter.rule(SCMP_ACT_ALLOW, SCMP_SYS(fcntl), SCMP_A1(SCMP_CMP_EQ, what));
  }
}

// Fail as if there were no such file. A descriptor's numbers, and how full a disk is, would tell
// what other processes do.
constexpr const char* kOfFiles =
    "access faccessat faccessat2 stat lstat fstat statx newfstatat readlink readlinkat "
    "getcwd chdir fchdir rmdir unlink unlinkat rename renameat renameat2 getdents64 "
    "truncate ftruncate fsync umask chmod fchmod fchmodat pread64 pwrite64 statfs fstatfs "
    "utimensat sendfile";

// What sanitizers and the dynamic loader need, which read files.
constexpr const char* kOfSanitizers =
    "access stat fstat newfstatat readlink readlinkat pipe pipe2 pread64";

}  // namespace

void restrict_to_submission_calls(bool sanitized) {
  Filter filter(SCMP_ACT_TRAP);
  allow_numbers(filter);
  write_to_nothing(filter, sanitized ? SCMP_ACT_ALLOW : no(ENOENT));
  if (sanitized) {
    filter.rules(SCMP_ACT_ALLOW, kOfSanitizers);
  } else {
    filter.rules(no(ENOENT), kOfFiles);
  }
  // Of all prctl operations, it may only set the process's name.
  filter.rule(SCMP_ACT_ALLOW, SCMP_SYS(prctl), SCMP_A0(SCMP_CMP_EQ, PR_SET_NAME));
  filter.rule(no(EPERM), SCMP_SYS(prctl), SCMP_A0(SCMP_CMP_NE, PR_SET_NAME));
  filter.install();
}

void start(char* const* command, char* const* environment) {
  ::syscall(SYS_execve, command[0], command, environment, secret);
}

void restrict_to_guard_calls() {
  Filter filter(SCMP_ACT_KILL_PROCESS);
  filter.rules(SCMP_ACT_ALLOW,
               "wait4 kill read readv write sendfile open openat close close_range fcntl fstat "
               "newfstatat lseek getdents64 unlink unlinkat rmdir getpid brk mmap munmap "
               "mremap mprotect futex rt_sigprocmask rt_sigreturn exit_group");
  filter.install();
}

void forbid_non_compiler_calls() {
  Filter filter(SCMP_ACT_ALLOW);
  filter.rules(no(EPERM),
               "socket socketpair connect ptrace process_vm_readv process_vm_writev "
               "pidfd_open pidfd_getfd kcmp kill tkill mount umount2 pivot_root chroot "
               "unshare setns setsid bpf perf_event_open userfaultfd keyctl add_key "
               "request_key io_uring_setup name_to_handle_at open_by_handle_at init_module "
               "finit_module kexec_load mknod mknodat personality");
  // clone3 hides its flags from a filter; without it, the C library uses clone.
  filter.rule(no(ENOSYS), SCMP_SYS(clone3));
  constexpr scmp_datum_t kNewUser = CLONE_NEWUSER;
  filter.rule(no(EPERM), SCMP_SYS(clone), SCMP_A0(SCMP_CMP_MASKED_EQ, kNewUser, kNewUser));
  filter.install();
}

}  // namespace bounce::box
