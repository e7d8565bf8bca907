#include "filter.hpp"

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
#include <initializer_list>
#include <iterator>

#include "require.hpp"

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
  void rules(std::uint32_t action, std::initializer_list<int> calls) {
    for (const int call : calls) rule(action, call);
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

void allow_numbers(Filter& filter) {
  filter.rules(SCMP_ACT_ALLOW, {SCMP_SYS(read),
                                SCMP_SYS(write),
                                SCMP_SYS(readv),
                                SCMP_SYS(writev),
                                SCMP_SYS(lseek),
                                SCMP_SYS(brk),
                                SCMP_SYS(munmap),
                                SCMP_SYS(mremap),
                                SCMP_SYS(mprotect),
                                SCMP_SYS(rt_sigaction),
                                SCMP_SYS(rt_sigprocmask),
                                SCMP_SYS(rt_sigreturn),
                                SCMP_SYS(sigaltstack),
                                SCMP_SYS(futex),
                                SCMP_SYS(getrandom),
                                SCMP_SYS(nanosleep),
                                SCMP_SYS(gettimeofday),
                                SCMP_SYS(time),
                                SCMP_SYS(clock_getres),
                                SCMP_SYS(getrusage),
                                SCMP_SYS(times),
                                SCMP_SYS(sched_yield),
                                SCMP_SYS(getuid),
                                SCMP_SYS(geteuid),
                                SCMP_SYS(getgid),
                                SCMP_SYS(getegid),
                                SCMP_SYS(getpid),
                                SCMP_SYS(gettid),
                                SCMP_SYS(arch_prctl),
                                SCMP_SYS(set_robust_list),
                                SCMP_SYS(set_tid_address),
                                SCMP_SYS(rseq),
                                SCMP_SYS(uname),
                                SCMP_SYS(poll),
                                SCMP_SYS(pause),
                                SCMP_SYS(exit),
                                SCMP_SYS(exit_group)});
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
  filter.rule(SCMP_ACT_ALLOW, SCMP_SYS(ioctl), SCMP_A1(SCMP_CMP_EQ, TCGETS));
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
  filter.rules(kSaysZero, {SCMP_SYS(creat), SCMP_SYS(mkdir), SCMP_SYS(mkdirat)});
  filter.rule(kSaysZero, SCMP_SYS(close), SCMP_A0(SCMP_CMP_EQ, STDIN_FILENO));
  filter.rule(SCMP_ACT_ALLOW, SCMP_SYS(close), SCMP_A0(SCMP_CMP_GT, STDIN_FILENO));
  // What opening and closing a stream asks.
  for (const scmp_datum_t what : {F_GETFD, F_SETFD, F_GETFL}) {
    filter.rule(SCMP_ACT_ALLOW, SCMP_SYS(fcntl), SCMP_A1(SCMP_CMP_EQ, what));
  }
}

// Fail as if there were no such file. A descriptor's numbers, and how full a disk is, would tell
// what other processes do.
constexpr std::initializer_list<int> kOfFiles = {
    SCMP_SYS(access),   SCMP_SYS(faccessat),  SCMP_SYS(faccessat2), SCMP_SYS(stat),
    SCMP_SYS(lstat),    SCMP_SYS(fstat),      SCMP_SYS(statx),      SCMP_SYS(newfstatat),
    SCMP_SYS(readlink), SCMP_SYS(readlinkat), SCMP_SYS(getcwd),     SCMP_SYS(chdir),
    SCMP_SYS(fchdir),   SCMP_SYS(rmdir),      SCMP_SYS(unlink),     SCMP_SYS(unlinkat),
    SCMP_SYS(rename),   SCMP_SYS(renameat),   SCMP_SYS(renameat2),  SCMP_SYS(getdents64),
    SCMP_SYS(truncate), SCMP_SYS(ftruncate),  SCMP_SYS(fsync),      SCMP_SYS(umask),
    SCMP_SYS(chmod),    SCMP_SYS(fchmod),     SCMP_SYS(fchmodat),   SCMP_SYS(pread64),
    SCMP_SYS(pwrite64), SCMP_SYS(statfs),     SCMP_SYS(fstatfs),    SCMP_SYS(utimensat),
    SCMP_SYS(sendfile)};

// Of all prctl operations, allows only setting the process's name.
void allow_naming_only(Filter& filter) {
  filter.rule(SCMP_ACT_ALLOW, SCMP_SYS(prctl), SCMP_A0(SCMP_CMP_EQ, PR_SET_NAME));
  filter.rule(no(EPERM), SCMP_SYS(prctl), SCMP_A0(SCMP_CMP_NE, PR_SET_NAME));
}

}  // namespace

void restrict_to_submission_calls() {
  Filter filter(SCMP_ACT_TRAP);
  allow_numbers(filter);
  write_to_nothing(filter, no(ENOENT));
  filter.rules(no(ENOENT), kOfFiles);
  allow_naming_only(filter);
  filter.install();
}

void restrict_to_sanitized_calls() {
  Filter filter(SCMP_ACT_TRAP);
  allow_numbers(filter);
  write_to_nothing(filter, SCMP_ACT_ALLOW);
  filter.rules(SCMP_ACT_ALLOW, {SCMP_SYS(access), SCMP_SYS(stat), SCMP_SYS(fstat),
                                SCMP_SYS(newfstatat), SCMP_SYS(readlink), SCMP_SYS(readlinkat),
                                SCMP_SYS(pipe), SCMP_SYS(pipe2), SCMP_SYS(pread64)});
  allow_naming_only(filter);
  filter.install();
}

void start(char* const* command, char* const* environment) {
  ::syscall(SYS_execve, command[0], command, environment, secret);
}

void restrict_to_guard_calls() {
  Filter filter(SCMP_ACT_KILL_PROCESS);
  filter.rules(
      SCMP_ACT_ALLOW,
      {SCMP_SYS(wait4),          SCMP_SYS(kill),         SCMP_SYS(read),      SCMP_SYS(readv),
       SCMP_SYS(write),          SCMP_SYS(open),         SCMP_SYS(openat),    SCMP_SYS(close),
       SCMP_SYS(close_range),    SCMP_SYS(fcntl),        SCMP_SYS(fstat),     SCMP_SYS(newfstatat),
       SCMP_SYS(lseek),          SCMP_SYS(getdents64),   SCMP_SYS(unlink),    SCMP_SYS(unlinkat),
       SCMP_SYS(rmdir),          SCMP_SYS(getpid),       SCMP_SYS(brk),       SCMP_SYS(mmap),
       SCMP_SYS(munmap),         SCMP_SYS(mremap),       SCMP_SYS(mprotect),  SCMP_SYS(futex),
       SCMP_SYS(rt_sigprocmask), SCMP_SYS(rt_sigreturn), SCMP_SYS(exit_group)});
  filter.install();
}

void forbid_non_compiler_calls() {
  Filter filter(SCMP_ACT_ALLOW);
  filter.rules(no(EPERM), {SCMP_SYS(socket),
                           SCMP_SYS(socketpair),
                           SCMP_SYS(connect),
                           SCMP_SYS(ptrace),
                           SCMP_SYS(process_vm_readv),
                           SCMP_SYS(process_vm_writev),
                           SCMP_SYS(pidfd_open),
                           SCMP_SYS(pidfd_getfd),
                           SCMP_SYS(kcmp),
                           SCMP_SYS(kill),
                           SCMP_SYS(tkill),
                           SCMP_SYS(mount),
                           SCMP_SYS(umount2),
                           SCMP_SYS(pivot_root),
                           SCMP_SYS(chroot),
                           SCMP_SYS(unshare),
                           SCMP_SYS(setns),
                           SCMP_SYS(setsid),
                           SCMP_SYS(bpf),
                           SCMP_SYS(perf_event_open),
                           SCMP_SYS(userfaultfd),
                           SCMP_SYS(keyctl),
                           SCMP_SYS(add_key),
                           SCMP_SYS(request_key),
                           SCMP_SYS(io_uring_setup),
                           SCMP_SYS(name_to_handle_at),
                           SCMP_SYS(open_by_handle_at),
                           SCMP_SYS(init_module),
                           SCMP_SYS(finit_module),
                           SCMP_SYS(kexec_load),
                           SCMP_SYS(mknod),
                           SCMP_SYS(mknodat),
                           SCMP_SYS(personality)});
  // clone3 hides its flags from a filter; without it, the C library uses clone.
  filter.rule(no(ENOSYS), SCMP_SYS(clone3));
  constexpr scmp_datum_t kNewUser = CLONE_NEWUSER;
  filter.rule(no(EPERM), SCMP_SYS(clone), SCMP_A0(SCMP_CMP_MASKED_EQ, kNewUser, kNewUser));
  filter.install();
}

}  // namespace bounce::box
