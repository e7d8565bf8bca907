// How the judge watches a runner and names its end; shell commands stand for runners. What the
// gallery's broken and hostile submissions show isn't repeated here.
#include "../../../grader/judge/runner_process.hpp"
#include "../../../grader/judge/process_usage.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <string>

namespace bounce::tests {
namespace {

using judge::KitFailure;
using judge::Limits;
using judge::RunnerEnded;
using judge::RunnerProcess;

// How one question to a runner ends. A failure of the kit has the status "kit".
RunnerEnded end_of(const std::string& script, const Limits& limits = {}) {
  std::signal(SIGPIPE, SIG_IGN);
  RunnerProcess runner({"/bin/sh", "-c", script}, limits);
  try {
    for (;;) {
      runner.send(frames::Frame());
      runner.receive();
    }
  } catch (const RunnerEnded& ended) {
    return ended;
  } catch (const KitFailure& failure) {
    return RunnerEnded({"kit", failure.what()});
  }
}

// A frame begins with its magic number; the rest of this one is zeros.
const std::string kFrame = "{ printf BNB1; head -c " +
                           std::to_string(sizeof(frames::Frame) - sizeof frames::kMagic) +
                           " /dev/zero; } >&4; ";
const std::string kThreads =
    "ulimit -s 256; export MALLOC_ARENA_MAX=1; exec python3 -c '"
    "import time\nfrom threading import Thread\n";
// A daemon: its parent is gone, and it has a session of its own.
const std::string kDaemon = "(setsid sh -c 'exec sleep 54321 >/dev/null 2>&1 3<&- 4>&-' &); ";

struct Row {
  std::string script;
  const char* status;
  const char* words;
  bool waits = false;  // and nothing more is asked of the part
  bool boxed = false;
};

const Row kRows[] = {
    {"exit 7", "no_answer", "exit status 7"},
    {"trap '' TERM INT HUP; sleep 1000", "timed_out", "the program waits for something", true},
    {"cat <&3 >/dev/null", "timed_out", "waits for something", true},
    // Printing wakes the judge, which then always finds the program at work.
    {"exec perl -e '$| = 1; while (1) { print \"x\\n\"; select(undef, undef, undef, 0.001) }'",
     "timed_out", "waits for something", true},
    // Where the box can't limit threads, because it can't tell them from others of the same user.
    {kThreads + "for _ in range(40): Thread(target=time.sleep, args=(9,)).start()'", "crashed",
     "more than 32 threads"},
    {"printf BNB1 >&4", "no_answer", "exit status 0"},
    // Byte by byte, a whole answer would take half a minute.
    {"exec perl -e 'open F, \">&=4\"; while (1) { syswrite F, \"B\"; select(undef, undef, undef, "
     ".025) }'",
     "timed_out", "only a part of an answer came", true},
    {"exec 3<&-; " + kFrame + "exec sleep 1000", "no_answer", "the pipe of its questions", true},
    {"cat /dev/zero >&4; sleep 1000", "no_answer", "isn't the answer that was asked for"},
    {"cat /dev/zero >&2", "no_answer", "printed more than 8 MB"},
    {"head -c 3000000 /dev/zero; echo 'x: y.cpp:3: f(): Assertion `a' \"' failed\"; "
     "kill -ABRT $$",
     "crashed", "an assertion failed: y.cpp:3: a"},
    {kDaemon + "exit 0", "no_answer", "exit status 0"},
    {kDaemon + "exec sleep 1000", "timed_out", "waits for something", true},
    // A box says on descriptor 5 that it is made; before, nobody's program is to blame.
    {"echo no room; exit 1", "kit", "couldn't be made", false, true},
    {"printf x >&5; exit 125", "kit", "couldn't be made", false, true},
    {"kill -KILL $$", "kit", "couldn't be made", false, true},
    {"printf m >&5; exit 1", "no_answer", "exit status 1", false, true},
    {"printf mx >&5; exit 125", "no_answer", "can't start the program", false, true},
    {"printf m >&5; sleep 0.2; printf x >&5", "no_answer", "can't start the program", false, true},
};

TEST(RunnerProcess, NamesTheEndOfARunner) {
  for (const Row& row : kRows) {
    Limits limits;
    limits.boxed = row.boxed;
    const RunnerEnded end = end_of(row.script, limits);
    EXPECT_EQ(end.termination.status, row.status) << row.script;
    EXPECT_NE(end.termination.sentence.find(row.words), std::string::npos)
        << row.script << ": " << end.termination.sentence;
    EXPECT_EQ(end.waits, row.waits) << row.script;
  }
  EXPECT_NE(std::system("pgrep -f '[s]leep 54321' >/dev/null"), 0) << "a daemon is left behind";
}

// On a busy machine nobody can tell how long threads that have ended wanted a CPU.
TEST(RunnerProcess, EndsOneThatSleepsWithThreadsOnceTheCpuHadNothingToDo) {
  Limits limits;
  limits.idle_seconds = 0.5;
  limits.wall_seconds = 5;
  const double before = judge::spare_seconds();
  const RunnerEnded end = end_of(
      kThreads + "while True:\n t = Thread(target=int)\n t.start()\n t.join()\n time.sleep(.02)'",
      limits);
  const bool busy = end.termination.sentence.find("too busy") != std::string::npos;
  EXPECT_TRUE(end.waits || busy) << end.termination.sentence;
  EXPECT_LT(judge::spare_seconds() - before, 2 * limits.idle_seconds + 1);
}

TEST(RunnerProcess, CountsNoTimeInWhichTheJudgeItselfIsStopped) {
  const std::string frozen = "kill -STOP $PPID; sleep 3; kill -CONT $PPID; " + kFrame;
  RunnerProcess runner({"/bin/sh", "-c", frozen + "exec sleep 1000"}, Limits());
  EXPECT_NO_THROW(runner.receive());
}

TEST(RunnerProcess, LeavesOtherRunnersAlone) {
  RunnerProcess other({"/bin/sh", "-c", kFrame + "exec sleep 1000"}, Limits());
  EXPECT_EQ(end_of("exit 0").termination.status, "no_answer");
  EXPECT_EQ(other.receive().magic, frames::kMagic);
}

}  // namespace
}  // namespace bounce::tests
