// The description of how a program ended.
#include "../../../grader/judge/termination.hpp"

#include <gtest/gtest.h>
#include <sys/syscall.h>
#include <sys/wait.h>

#include <csignal>
#include <string>

#include "../../../grader/runner/crash.hpp"

namespace bounce::tests {
namespace {

using judge::Termination;

Termination by_signal(int signal, const std::string& print = "") {
  return judge::termination_of(W_EXITCODE(0, signal), judge::Limits(), print);
}

Termination by_exit(int status) {
  return judge::termination_of(W_EXITCODE(status, 0), judge::Limits(), "");
}

std::string cause(const std::string& words) { return "\n" + (runner::kCause + words) + "\n"; }

void expect(const Termination& termination, const std::string& status, const std::string& words) {
  EXPECT_EQ(termination.status, status);
  EXPECT_NE(termination.sentence.find(words), std::string::npos) << termination.sentence;
  EXPECT_EQ(termination.sentence.find('\n'), std::string::npos) << termination.sentence;
}

TEST(Termination, EachSignalHasWordsOfItsOwn) {
  expect(by_signal(SIGSEGV), "crashed", "segmentation fault");
  expect(by_signal(SIGABRT), "crashed", "aborted");
  expect(by_signal(SIGFPE), "crashed", "integer division by zero");
  expect(by_signal(SIGILL), "crashed", "a function that returns no value");
  expect(by_signal(SIGBUS), "crashed", "bus error");
  expect(by_signal(SIGTRAP), "crashed", "trap");
  expect(by_signal(SIGXFSZ), "crashed", "write a file");
  expect(by_signal(SIGKILL), "crashed",
         "killed: by itself, or by the system for want of memory or time");
  expect(by_signal(SIGXCPU), "timed_out", "more than 1 s of CPU time");
  expect(by_signal(SIGTERM), "crashed", "signal SIGTERM, which it sent itself");
  expect(by_signal(SIGALRM), "crashed", "signal SIGALRM");
  expect(by_signal(SIGRTMIN + 1), "crashed", "signal " + std::to_string(SIGRTMIN + 1));
}

TEST(Termination, OneThatStoresWithoutEndIsOutOfMemoryWhateverEndsItFirst) {
  const judge::Limits limits;
  for (const int signal : {SIGXCPU, SIGKILL}) {
    const int status = W_EXITCODE(0, signal);
    expect(judge::termination_of(status, limits, "", limits.memory / 2), "out_of_memory",
           "stores without end");
  }
  const std::size_t little = limits.memory / 100;
  expect(judge::termination_of(W_EXITCODE(0, SIGXCPU), limits, "", little), "timed_out",
         "CPU time");
  expect(judge::termination_of(W_EXITCODE(0, SIGKILL), limits, "", little), "crashed", "killed");
}

TEST(Termination, TellsASignalThroughABoxAsWell) {
  for (const int signal : {SIGSEGV, SIGABRT, SIGXCPU, SIGSYS, SIGKILL}) {
    EXPECT_EQ(by_exit(128 + signal).sentence, by_signal(signal).sentence);
    EXPECT_EQ(by_exit(128 + signal).status, by_signal(signal).status);
  }
}

TEST(Termination, NamesWhatASanitizerFound) {
  const auto found = [](const std::string& kind) {
    return by_signal(SIGABRT, cause(runner::kFound + kind));
  };
  expect(found("stack-use-after-scope"), "crashed", "a variable that is gone");
  expect(found("out-of-bounds-index"), "crashed", "out of the bounds of a C array");
}

TEST(Termination, RepeatsNothingThatIsNoNameOfASanitizers) {
  const Termination termination =
      by_signal(SIGABRT, cause(std::string(runner::kFound) + "SECRET=1"));
  expect(termination, "crashed", "aborted");
  EXPECT_EQ(termination.sentence.find("SECRET"), std::string::npos);
}

TEST(Termination, ExitIsNoAnswer) {
  expect(by_exit(0), "no_answer", "ended by itself (exit status 0)");
  expect(by_exit(3), "no_answer", "ended by itself (exit status 3)");
  expect(by_exit(255), "no_answer", "ended by itself (exit status 255)");
}

TEST(Termination, NamesWhyASegmentationFaultCame) {
  expect(by_signal(SIGSEGV, cause(runner::kNull)), "crashed", "fault: it followed a null pointer");
  expect(by_signal(SIGSEGV, cause(runner::kFullStack)), "crashed",
         "its stack is full: a recursion without end");
  expect(by_signal(SIGSEGV, cause(runner::kUnknown)), "crashed", "an index out of range");
}

TEST(Termination, TellsADivisionByZeroFromATrapThatWasAskedFor) {
  expect(by_signal(SIGFPE, cause(runner::kDivision)), "crashed", "integer division by zero");
  expect(by_signal(SIGFPE, cause(runner::kFloat)), "crashed", "turned floating-point traps on");
}

TEST(Termination, NamesTheRefusedCall) {
  const auto call = [](long number) {
    return by_signal(SIGSYS, cause(runner::kCall + std::to_string(number)));
  };
  expect(call(SYS_socket), "crashed", "isn't given: a connection (socket)");
  expect(call(SYS_clone), "crashed", "isn't given: another process (clone)");
  expect(call(SYS_ptrace), "crashed", "isn't given: another process's memory (ptrace)");
  expect(call(4000), "crashed", "isn't given: system call 4000");
  expect(by_signal(SIGSYS), "crashed", "isn't given: a process, a thread, a file, a connection");
}

TEST(Termination, NamesAnAssertion) {
  expect(by_signal(SIGABRT,
                   "runner: /usr/include/eigen3/Eigen/src/Core/DenseCoeffsBase.h:366: Scalar& f() "
                   "[with T = int]: Assertion `index >= 0 && index < size()' failed.\n"),
         "crashed", "an assertion failed: an index is out of range");
  expect(by_signal(SIGABRT,
                   "/usr/include/c++/12/bits/stl_vector.h:1123: reference "
                   "std::vector<double>::operator[](size_type): Assertion '__n < "
                   "this->size()' failed.\n" +
                       cause(runner::kUnknown)),
         "crashed", "an assertion failed: an index beyond the end of a std::vector or std::array");
  expect(by_signal(SIGABRT, "runner: part1.cpp:7: void f(): Assertion `mass > 0' failed."),
         "crashed", "an assertion failed: part1.cpp:7: mass > 0");
}

TEST(Termination, NamesAnExceptionThatNothingCaught) {
  expect(by_signal(SIGABRT,
                   "hello\nterminate called after throwing an instance of "
                   "'std::out_of_range'\n  what():  vector::_M_range_check\n" +
                       cause(runner::kUnknown)),
         "crashed", "std::out_of_range: vector::_M_range_check");
  expect(by_signal(SIGABRT, "terminate called after throwing an instance of 'int'\n"), "crashed",
         "threw where nothing catches it");
}

TEST(Termination, NamesMemoryThatRanOutBeforeMain) {
  expect(by_signal(SIGABRT,
                   "terminate called after throwing an instance of 'std::bad_alloc'\n"
                   "  what():  std::bad_alloc\n"),
         "out_of_memory", "ran out of memory (1024 MB)");
}

TEST(Termination, NamesMemoryThatWasFreedTwice) {
  expect(by_signal(SIGABRT, "free(): double free detected in tcache 2\n" + cause("unknown")),
         "crashed", "freed some twice (free(): double free detected in tcache 2)");
}

TEST(Termination, KeepsTheStackOfACrashAlone) {
  const std::string stack = "stack of the crash: 0x0000000000401000 0x0000000000402000\n";
  EXPECT_EQ(by_signal(SIGSEGV, stack).stack, " 0x0000000000401000 0x0000000000402000");
  EXPECT_EQ(by_signal(SIGSEGV, "stack of the crash: -e /etc/passwd\n").stack, "");
  EXPECT_EQ(by_signal(SIGSEGV, "stack of the crash: 0x1 0x2\n").stack, "");
  std::string most = " 0x0000000000401000";
  while (most.size() < 40 * 19) most += " 0x0000000000402000";
  EXPECT_EQ(by_signal(SIGSEGV, "stack of the crash:" + most + "\n").stack, most);
  EXPECT_EQ(by_signal(SIGSEGV, "stack of the crash:" + most + " 0x0000000000402000\n").stack, "");
  EXPECT_EQ(by_signal(SIGXCPU, stack).stack, "");
}

// A program's text must not cost the judge much time or overflow its stack.
TEST(Termination, OutlivesAnyPrint) {
  const std::string tall(16 * 1024, ':');
  const std::string wide = "a.b:1: " + std::string(16 * 1024, '`');
  for (const std::string& print :
       {tall, wide, ": Assertion " + tall, wide + ": Assertion " + wide + "' failed",
        std::string(": Assertion "),
        std::string("terminate called after throwing an instance of '"),
        std::string("\0\0: Assertion \0", 16), "\x1b[2J" + tall}) {
    const Termination termination = by_signal(SIGABRT, print);
    EXPECT_EQ(termination.status, "crashed");
    EXPECT_LT(termination.sentence.size(), 800u);
    EXPECT_EQ(termination.sentence.find('\x1b'), std::string::npos);
  }
}

}  // namespace
}  // namespace bounce::tests
