// write_filter FILE: the system calls that a numerical program needs, as a seccomp filter for the
// run box. Files, connections and further processes are what it doesn't need.
#include <fcntl.h>
#include <seccomp.h>
#include <unistd.h>

#include <cerrno>
#include <initializer_list>
#include <iostream>
#include <stdexcept>
#include <string>

namespace {

void require(int result, const std::string& what) {
  if (result < 0) throw std::runtime_error(what + " failed with " + std::to_string(result));
}

// execve and wait4 are the box's own: one process of it starts the runner and waits for its end.
// The runner finds nothing else to start, and nobody to wait for.
constexpr auto kAllowed = {
    SCMP_SYS(read),
    SCMP_SYS(write),
    SCMP_SYS(readv),
    SCMP_SYS(writev),
    SCMP_SYS(lseek),
    SCMP_SYS(fstat),
    SCMP_SYS(newfstatat),
    SCMP_SYS(close),
    SCMP_SYS(brk),
    SCMP_SYS(mmap),
    SCMP_SYS(munmap),
    SCMP_SYS(mremap),
    SCMP_SYS(mprotect),
    SCMP_SYS(madvise),
    SCMP_SYS(rt_sigaction),
    SCMP_SYS(rt_sigprocmask),
    SCMP_SYS(rt_sigreturn),
    SCMP_SYS(sigaltstack),
    SCMP_SYS(futex),
    SCMP_SYS(getrandom),
    SCMP_SYS(clock_gettime),
    SCMP_SYS(clock_nanosleep),
    SCMP_SYS(nanosleep),
    SCMP_SYS(gettimeofday),
    SCMP_SYS(time),
    SCMP_SYS(sched_yield),
    SCMP_SYS(getpid),
    SCMP_SYS(gettid),
    SCMP_SYS(tgkill),
    SCMP_SYS(prlimit64),
    SCMP_SYS(arch_prctl),
    SCMP_SYS(set_tid_address),
    SCMP_SYS(set_robust_list),
    SCMP_SYS(rseq),
    SCMP_SYS(prctl),
    SCMP_SYS(uname),
    SCMP_SYS(ioctl),
    SCMP_SYS(poll),
    SCMP_SYS(pause),
    SCMP_SYS(execve),
    SCMP_SYS(wait4),
    SCMP_SYS(exit),
    SCMP_SYS(exit_group),
};

// What a program may try without harm: it is told no, as if there were no such file.
constexpr auto kRefused = {
    SCMP_SYS(open),  SCMP_SYS(openat), SCMP_SYS(access),   SCMP_SYS(faccessat),  SCMP_SYS(stat),
    SCMP_SYS(lstat), SCMP_SYS(statx),  SCMP_SYS(readlink), SCMP_SYS(readlinkat), SCMP_SYS(getcwd),
    SCMP_SYS(mkdir), SCMP_SYS(unlink), SCMP_SYS(rename),
};

void write_filter(const char* path) {
  const scmp_filter_ctx filter = seccomp_init(SCMP_ACT_KILL_PROCESS);
  if (!filter) throw std::runtime_error("seccomp_init failed");
  for (const int call : kAllowed)
    require(seccomp_rule_add(filter, SCMP_ACT_ALLOW, call, 0), "allow");
  for (const int call : kRefused) {
    require(seccomp_rule_add(filter, SCMP_ACT_ERRNO(ENOENT), call, 0), "refuse");
  }
  const int fd = ::open(path, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  require(fd, std::string("opening ") + path);
  require(seccomp_export_bpf(filter, fd), "writing");
  ::close(fd);
  seccomp_release(filter);
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 2) throw std::runtime_error("usage: write_filter FILE");
  write_filter(argv[1]);
  return 0;
} catch (const std::exception& e) {
  std::cerr << "write_filter: " << e.what() << "\n";
  return 1;
}
