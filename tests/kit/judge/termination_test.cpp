// The description of how a program ended: by its wait status and its last print, which may hold the
// runner's report of a crash. What real crashes report, the gallery and gradings.toml show.
#include "../../../grader/judge/termination.hpp"
#include "../../../grader/words/sentences.hpp"

#include <gtest/gtest.h>
#include <sys/syscall.h>
#include <sys/wait.h>

#include <csignal>
#include <string>

#include "../../../grader/runner/crash.hpp"

namespace bounce::tests {
namespace {

using namespace std::string_literals;
using judge::Termination;

// The runner's own line on the cause of a crash, and others' last words.
std::string cause(const std::string& words) { return "\n" + (runner::kCause + words) + "\n"; }
std::string call(long number) { return cause(runner::kCall + std::to_string(number)); }
std::string found(const std::string& kind) { return cause(runner::kFound + kind); }

constexpr const char* kBadAlloc =
    "terminate called after throwing an instance of 'std::bad_alloc'\n";

Termination by_signal(int signal, const std::string& print = "", std::size_t memory = 0) {
  return judge::termination_of(W_EXITCODE(0, signal), judge::Limits(), print, memory);
}

struct Row {
  int signal;
  std::string print;
  std::string end;  // its line
};

const Row kRows[] = {
    {SIGFPE, "", "crashed: signal 8"},
    {SIGSEGV, cause(runner::kUnknown), "crashed: signal 11, unknown"},
    {SIGXCPU, "", "timed_out: worked 1"},
    {SIGRTMIN + 1, "", "crashed: signal " + std::to_string(SIGRTMIN + 1)},
    {SIGSYS, "", "crashed: signal 31"},
    {SIGSYS, call(SYS_socket), "crashed: call " + std::to_string(SYS_socket) + ", socket"},
    {SIGSYS, call(4000), "crashed: call 4000"},
    {SIGABRT, found("SECRET=1"), "crashed: aborted 6"},
    {SIGABRT, kBadAlloc, "out_of_memory: out of memory 1024"},
    {SIGABRT, kBadAlloc + "hello\n"s + cause(runner::kUnknown),
     "out_of_memory: out of memory 1024"},
    {SIGABRT, "free(): double free\n" + cause(runner::kUnknown) + "stack",
     "crashed: overwrote 6, free(): double free"},
};

TEST(Termination, SaysInOneLineHowAProgramEnded) {
  for (const Row& row : kRows) {
    EXPECT_EQ(judge::in_one_line(by_signal(row.signal, row.print)), row.end);
  }
}

// Elsewhere a submission may have written the name.
TEST(Termination, BelievesNamesOfSanitizersWhereTheyAreLinkedAlone) {
  judge::Limits limits;
  limits.sanitized = true;
  const int aborted = W_EXITCODE(0, SIGABRT);
  const Termination end = judge::termination_of(aborted, limits, found("double-free"));
  EXPECT_EQ(judge::in_one_line(end), "crashed: sanitizer 6, double-free");
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
  for (int i = 0; i < runner::kFrames; ++i) most += frame;
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
    EXPECT_LT(judge::in_one_line(end).size(), 800u);
  }
}

TEST(OneLine, LeavesOneLineOfBoundedLengthAndNoHalfOfACharacter) {
  const std::string many(40, 'a');
  const std::pair<std::string, std::string> rows[] = {
      {"", ""},
      {"Übung ½ θ → 日本 🙂, <b>&amp;=1", "Übung ½ θ → 日本 🙂, <b>&amp;=1"},
      {"a\nb\r\tc\x1b[2J", "a b c\x1b[2J"},
      {many, many},
      {many + "a", many + "..."},
      {many.substr(1) + "θ", many.substr(1) + "..."},
  };
  for (const auto& [text, line] : rows) EXPECT_EQ(words::one_line(text, 40), line);
}

}  // namespace
}  // namespace bounce::tests
