// The description of how a program ended: by its wait status and its last print, which may hold the
// runner's report of a crash.
#include "../../../grader/judge/termination.hpp"

#include <gtest/gtest.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <functional>
#include <string>

#include "../../../grader/judge/sanitize_line.hpp"
#include "../../../grader/runner/crash.hpp"

namespace bounce::tests {
namespace {

using namespace std::string_literals;
using judge::Termination;

// The runner's own line on the cause of a crash, and others' last words.
std::string cause(const std::string& words) { return "\n" + (runner::kCause + words) + "\n"; }
std::string call(long number) { return cause(runner::kCall + std::to_string(number)); }
std::string found(const std::string& kind) { return cause(runner::kFound + kind); }

std::string thrown(const std::string& type, const std::string& what = "") {
  return "terminate called after throwing an instance of '" + type + "'\n" +
         (what.empty() ? "" : "  what():  " + what + "\n");
}

std::string failed(const std::string& what) {
  return "a print\nrunner: /usr/include/eigen3/Eigen/src/Core/Block.h:120: Eigen::Block<X>::"
         "Block(X&, Index): Assertion `" +
         what + "' failed.\nmore";
}

Termination by_signal(int signal, const std::string& print = "", std::size_t memory = 0) {
  return judge::termination_of(W_EXITCODE(0, signal), judge::Limits(), print, memory);
}

struct Row {
  int signal;
  std::string print;
  const char* status;
  std::string words;
};

const Row kRows[] = {
    {SIGFPE, "", "crashed", "integer division by zero"},
    {SIGBUS, "", "crashed", "bus error"},
    {SIGXFSZ, "", "crashed", "write a file"},
    {SIGXCPU, "", "timed_out", "more than 1 s of CPU time"},
    {SIGTERM, "", "crashed", "signal SIGTERM, which it sent itself"},
    {SIGRTMIN + 1, "", "crashed", "signal " + std::to_string(SIGRTMIN + 1)},
    {SIGSYS, "", "crashed", "isn't given: a process, a thread, a file, a connection"},
    {SIGSYS, call(SYS_socket), "crashed", "isn't given: a connection (socket)"},
    {SIGSYS, call(SYS_ptrace), "crashed", "isn't given: another process's memory (ptrace)"},
    {SIGSYS, call(4000), "crashed", "isn't given: system call 4000"},
    {SIGSEGV, cause(runner::kUnknown), "crashed", "an index out of range"},
    {SIGABRT, found("stack-use-after-scope"), "crashed", "a variable that is gone"},
    {SIGABRT, found("out-of-bounds-index"), "crashed", "out of the bounds of a C array"},
    {SIGABRT, found("SECRET=1"), "crashed", "called abort() or std::terminate(), perhaps"},
    {SIGABRT, "hello\n" + thrown("std::out_of_range", "vector") + cause(runner::kUnknown),
     "crashed", "std::out_of_range: vector"},
    {SIGABRT, thrown("std::bad_alloc", "std::bad_alloc"), "out_of_memory",
     "ran out of memory (1024 MB)"},
    {SIGABRT, "free(): double free detected in tcache 2\n" + cause("unknown"), "crashed",
     "freed some twice (free(): double free detected in tcache 2)"},
    // Assertions: their words, or what Eigen's and the library's mean.
    {SIGABRT, "runner: part1.cpp:7: void f(): Assertion `mass > 0' failed.", "crashed",
     "an assertion failed: part1.cpp:7: mass > 0"},
    {SIGABRT, failed("(i>=0) && (i<rows())"), "crashed", "Block.h:120: (i>=0) && (i<rows())"},
    {SIGABRT, failed("index >= 0 && index < size()"), "crashed", "an index is out of range"},
    {SIGABRT,
     failed("lhs.cols() == rhs.rows() && \"invalid matrix product\" && \"if you wanted a "
            "coeff-wise or a dot product use the respective explicit functions\""),
     "crashed",
     "a product whose left matrix has another number of columns than the right one has rows"},
    {SIGABRT, failed("aLhs.rows() == aRhs.rows() && aLhs.cols() == aRhs.cols()"), "crashed",
     "a sum, a difference or another operation by entries on two different shapes"},
    {SIGABRT,
     failed("((m_row+m_currentBlockRows) == m_xpr.rows() || m_xpr.cols() == 0) && m_col == "
            "m_xpr.cols() && \"Too few coefficients passed to comma initializer (operator<<)\""),
     "crashed", "<< with fewer numbers than the matrix has"},
    {SIGABRT,
     failed("(i>=0) && ( ((BlockRows==1) && (BlockCols==XprType::ColsAtCompileTime) && "
            "i<xpr.rows()) ||((BlockRows==XprType::RowsAtCompileTime) && (BlockCols==1) && "
            "i<xpr.cols()))"),
     "crashed", "a row or a column that the matrix doesn't have"},
    {SIGABRT,
     "/usr/include/c++/12/bits/stl_vector.h:1123: reference std::vector<double>::operator[]"
     "(size_type): Assertion '__n < this->size()' failed.\n" +
         cause(runner::kUnknown),
     "crashed", "an assertion failed: an index beyond the end of a std::vector or std::array"},
    {SIGABRT, "x:1: Assertion x failed", "crashed", "called abort()"},
    {SIGABRT, ":1: Assertion `x' failed", "crashed", "called abort()"},
    {SIGABRT, "x:: Assertion `x' failed", "crashed", "called abort()"},
    {SIGABRT, "Assertion `x' failed", "crashed", "called abort()"},
};

TEST(Termination, SaysInOneLineHowAProgramEnded) {
  for (const Row& row : kRows) {
    const Termination end = by_signal(row.signal, row.print);
    EXPECT_EQ(end.status, row.status) << row.words;
    EXPECT_NE(end.sentence.find(row.words), std::string::npos) << end.sentence;
    EXPECT_EQ(end.sentence.find('\n'), std::string::npos) << end.sentence;
    EXPECT_EQ(end.sentence.find("SECRET"), std::string::npos) << end.sentence;
  }
}

TEST(Termination, OneThatStoresWithoutEndIsOutOfMemoryWhateverEndsItFirst) {
  const std::size_t all = judge::Limits().memory;
  EXPECT_EQ(by_signal(SIGXCPU, "", all / 2).status, "out_of_memory");
  EXPECT_EQ(by_signal(SIGKILL, "", all / 2).status, "out_of_memory");
  EXPECT_EQ(by_signal(SIGXCPU, "", all / 9).status, "timed_out");
  EXPECT_EQ(by_signal(SIGKILL, "", all / 9).status, "crashed");
}

TEST(Termination, KeepsTheStackOfACrashAlone) {
  const std::string frame = " 0x0000000000401000";
  const auto stack = [](int signal, const std::string& addresses) {
    return by_signal(signal, "stack of the crash:" + addresses + "\n").stack;
  };
  std::string most;
  for (int i = 0; i < 40; ++i) most += frame;
  EXPECT_EQ(stack(SIGSEGV, frame + frame), frame + frame);
  EXPECT_EQ(stack(SIGSEGV, most), most);
  for (const std::string& none : {most + frame, std::string(" -e /etc/passwd"), frame + " 0x2"}) {
    EXPECT_EQ(stack(SIGSEGV, none), "");
  }
  EXPECT_EQ(stack(SIGXCPU, frame), "");
}

// A megabyte, far more than is ever kept. A careless reader takes quadratic time, which is minutes,
// or overflows its stack.
TEST(Termination, OutlivesAnyPrint) {
  for (const std::string word : {"a", ":", "`", "a:1: ", "1:", "Assertion `", "a:1: Assertion `",
                                 "\n", "' failed", "a:1: Assertion `x' faile"}) {
    std::string print;
    while (print.size() < 1'000'000) print += word;
    const Termination end = by_signal(SIGABRT, print + "' failed");
    EXPECT_EQ(end.status, "crashed");
    EXPECT_LT(end.sentence.size(), 800u);
  }
}

TEST(SanitizeLine, LeavesOneLineOfBoundedLengthAndNoHalfOfACharacter) {
  const std::string many(40, 'a');
  const std::pair<std::string, std::string> rows[] = {
      {"", ""},
      {"Übung ½ θ → 日本 🙂, <b>&amp;=1", "Übung ½ θ → 日本 🙂, <b>&amp;=1"},
      {"a\nb\r\tc\x1b[2J", "a b  c\x1b[2J"},
      {many, many},
      {many + "a", many + "..."},
      {many.substr(1) + "θ", many.substr(1) + "..."},
  };
  for (const auto& [text, line] : rows) EXPECT_EQ(judge::sanitize_line(text, 40), line);
}

// --- what a real crash reports: a child of this process crashes ---

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

void fill_the_stack() {
  volatile int depth = 0;
  zero = deeper(&depth);
}

Termination after(const std::function<void()>& crash) {
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

TEST(Crash, SaysWhatItWas) {
  const std::pair<std::function<void()>, const char*> rows[] = {
      {[] { write_to(nowhere); }, "it followed a null pointer"},
      {[] { write_to(nowhere + 100); }, "it followed a null pointer"},
      {[] { write_to(wild); }, "memory that isn't its own"},
      {fill_the_stack, "its stack is full"},
      {[] { divide_by(zero); }, "an integer division by zero"},
      {[] { ::raise(SIGSEGV); }, "segmentation fault"},
  };
  for (const auto& [crash, words] : rows) {
    const Termination end = after(crash);
    EXPECT_EQ(end.status, "crashed") << words;
    EXPECT_NE(end.sentence.find(words), std::string::npos) << end.sentence;
    EXPECT_EQ(end.stack.substr(0, 3), " 0x") << words;
  }
}

}  // namespace
}  // namespace bounce::tests
