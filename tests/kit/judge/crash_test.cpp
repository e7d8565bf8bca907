// The report of a crash, and the message made from it. A child of this process crashes.
#include "../../../grader/runner/crash.hpp"

#include <fenv.h>
#include <gtest/gtest.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstddef>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include "../../../grader/judge/termination.hpp"

namespace bounce::tests {
namespace {

judge::Termination after(const std::function<void()>& crash) {
  int prints[2];
  EXPECT_EQ(::pipe(prints), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    ::dup2(prints[1], STDERR_FILENO);
    crash();
    ::_exit(0);
  }
  ::close(prints[1]);
  std::string print;
  char chunk[4096];
  for (ssize_t n = 0; (n = ::read(prints[0], chunk, sizeof chunk)) > 0;) {
    print.append(chunk, static_cast<std::size_t>(n));
  }
  ::close(prints[0]);
  int status = 0;
  EXPECT_EQ(::waitpid(child, &status, 0), child);
  return judge::termination_of(status, judge::Limits(), print);
}

void expect(const judge::Termination& termination, const std::string& words) {
  EXPECT_EQ(termination.status, "crashed");
  EXPECT_NE(termination.sentence.find(words), std::string::npos) << termination.sentence;
  EXPECT_EQ(termination.stack.substr(0, 3), " 0x");
}

int* volatile nowhere = nullptr;
int* volatile wild = reinterpret_cast<int*>(std::uintptr_t{0x123456789000});
volatile int zero = 0;

// UBSan would end the program before it crashes.
[[gnu::no_sanitize("undefined")]] void write_to(int* place) { *place = 1; }
[[gnu::no_sanitize("undefined")]] void divide_by(int divisor) { zero = 7 / divisor; }

int deeper(volatile int* depth) {
  if (*depth < 0) return 0;
  volatile int here[1000] = {*depth + 1};
  return deeper(here) + here[7];
}

// As in the box's filter: a signal replaces the call.
void trap_sockets() {
  sock_filter rules[] = {
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_socket, 0, 1),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_TRAP),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
  };
  const sock_fprog program{4, rules};
  ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
  ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program);
}

TEST(Crash, TellsANullPointer) {
  expect(after([] { write_to(nowhere); }), "it followed a null pointer");
  expect(after([] { write_to(nowhere + 100); }), "it followed a null pointer");
}

TEST(Crash, TellsMemoryThatIsNotItsOwn) {
  expect(after([] { write_to(wild); }), "memory that isn't its own");
}

TEST(Crash, TellsAFullStack) {
  expect(after([] {
           volatile int depth = 0;
           zero = deeper(&depth);
         }),
         "its stack is full");
}

TEST(Crash, TellsADivisionFromFloatingPoint) {
  expect(after([] { divide_by(zero); }), "an integer division by zero");
#ifdef __x86_64__  // elsewhere such traps may not be had
  expect(after([] {
           ::feenableexcept(FE_DIVBYZERO);
           volatile double x = 0;
           x = 1 / x;
         }),
         "turned floating-point traps on");
#endif
}

TEST(Crash, TellsTheRefusedCall) {
  expect(after([] {
           trap_sockets();
           ::socket(AF_INET, SOCK_STREAM, 0);
         }),
         "asked the system for what it isn't given: a connection (socket)");
}

TEST(Crash, EndsByASignalThatItSentItself) {
  expect(after([] { ::raise(SIGSEGV); }), "segmentation fault");
  expect(after([] { std::abort(); }), "it called abort() or std::terminate()");
}

TEST(Crash, KeepsTheWordsBeforeIt) {
  expect(after([]() noexcept { std::vector<int>().at(3); }),
         "threw where nothing catches it (before main, in a destructor, in a noexcept function or "
         "in what()): std::out_of_range: vector");
}

}  // namespace
}  // namespace bounce::tests
