#include "system_call.hpp"

#include <sys/syscall.h>

#include <map>

namespace bounce::judge {
namespace {

const std::map<long, std::string> kAsked = {
    {SYS_clone, "another process (clone)"},
    {SYS_clone3, "another process or thread (clone3)"},
    {SYS_execve, "another program (execve)"},
    {SYS_execveat, "another program (execveat)"},
    {SYS_socket, "a connection (socket)"},
    {SYS_socketpair, "a connection (socketpair)"},
    {SYS_connect, "a connection (connect)"},
    {SYS_kill, "a signal to a process (kill)"},
    {SYS_tgkill, "a signal to another program (tgkill)"},
    {SYS_prlimit64, "other limits (prlimit64)"},
    {SYS_tkill, "a signal to a thread (tkill)"},
    {SYS_getppid, "the process that started it (getppid)"},
    {SYS_ptrace, "another process's memory (ptrace)"},
    {SYS_process_vm_readv, "another process's memory (process_vm_readv)"},
    {SYS_process_vm_writev, "another process's memory (process_vm_writev)"},
    {SYS_pidfd_open, "a hold on a process (pidfd_open)"},
    {SYS_setsid, "a session of its own (setsid)"},
    {SYS_setitimer, "a timer (setitimer)"},
    {SYS_timer_create, "a timer (timer_create)"},
    {SYS_timerfd_create, "a timer (timerfd_create)"},
    {SYS_pipe2, "a pipe (pipe2)"},
    {SYS_dup, "another name for a descriptor (dup)"},
    {SYS_dup3, "another name for a descriptor (dup3)"},
    {SYS_fcntl, "a change of a descriptor (fcntl)"},
    {SYS_memfd_create, "a file in memory (memfd_create)"},
    {SYS_getdents64, "the names in a folder (getdents64)"},
    {SYS_symlinkat, "a link (symlinkat)"},
    {SYS_linkat, "a link (linkat)"},
    {SYS_mknodat, "a device or a pipe in a folder (mknodat)"},
    {SYS_mount, "another file system (mount)"},
    {SYS_unshare, "a box of its own (unshare)"},
    {SYS_setns, "another box (setns)"},
    {SYS_setuid, "another user's rights (setuid)"},
    {SYS_getuid, "its user (getuid)"},
    {SYS_geteuid, "its user (geteuid)"},
    {SYS_seccomp, "another filter (seccomp)"},
    {SYS_bpf, "a program in the kernel (bpf)"},
    {SYS_perf_event_open, "the kernel's counters (perf_event_open)"},
    {SYS_io_uring_setup, "the kernel's queues (io_uring_setup)"},
    {SYS_userfaultfd, "the faults of its memory (userfaultfd)"},
    {SYS_sched_setaffinity, "another CPU (sched_setaffinity)"},
#ifdef SYS_fork  // old calls, which newer architectures don't have
    {SYS_fork, "another process (fork)"},
    {SYS_vfork, "another process (vfork)"},
    {SYS_pipe, "a pipe (pipe)"},
    {SYS_dup2, "another name for a descriptor (dup2)"},
    {SYS_alarm, "a timer (alarm)"},
    {SYS_getdents, "the names in a folder (getdents)"},
    {SYS_symlink, "a link (symlink)"},
    {SYS_link, "a link (link)"},
    {SYS_mknod, "a device or a pipe in a folder (mknod)"},
#endif
};

}  // namespace

std::string what_is_asked_by(long system_call) {
  const auto known = kAsked.find(system_call);
  return known == kAsked.end() ? "system call " + std::to_string(system_call) : known->second;
}

}  // namespace bounce::judge
