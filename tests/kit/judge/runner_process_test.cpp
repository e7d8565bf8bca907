// How the judge watches a runner and names its end; shell commands stand for runners. What the
// gallery's broken and hostile submissions show isn't repeated here.
#include "../../../grader/judge/runner_process.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

namespace bounce::tests {
namespace {

using judge::KitFailure;
using judge::Limits;
using judge::RunnerProcess;
using judge::Termination;

// How one question to a runner ends. A failure of the kit has the status "kit".
Termination end_of(const std::string& script, const Limits& limits = {}) {
  std::signal(SIGPIPE, SIG_IGN);
  RunnerProcess runner({"/bin/sh", "-c", script}, limits);
  try {
    for (;;) {
      runner.send(frames::Frame());
      runner.receive();
    }
  } catch (const Termination& ended) {
    return ended;
  } catch (const KitFailure& failure) {
    return {"kit", failure.what()};
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

struct Script {
  std::string script;
  const char* end;     // how its line begins
  bool waits = false;  // and nothing more is asked of the part
  bool boxed = false;
};

const Script kScripts[] = {
    {"exit 7", "no_answer: exited 7"},
    {"trap '' TERM INT HUP; sleep 1000", "timed_out: waited 0", true},
    {"cat <&3 >/dev/null", "timed_out: waited 0", true},
    // Printing wakes the judge, which then always finds the program at work.
    {"exec perl -e '$| = 1; while (1) { print \"x\\n\"; select(undef, undef, undef, 0.001) }'",
     "timed_out: waited 0", true},
    // Where the box can't limit threads, because it can't tell them from others of the same user.
    {kThreads + "for _ in range(40): Thread(target=time.sleep, args=(9,)).start()'",
     "crashed: threads 32"},
    {"printf BNB1 >&4", "no_answer: exited 0"},
    // Byte by byte, a whole answer would take half a minute.
    {"exec perl -e 'open F, \">&=4\"; while (1) { syswrite F, \"B\"; select(undef, undef, undef, "
     ".025) }'",
     "timed_out: waited 0, a part of an answer", true},
    {"exec 3<&-; " + kFrame + "exec sleep 1000", "no_answer: closed 0, questions (descriptor 3)",
     true},
    {"cat /dev/zero >&4; sleep 1000", "no_answer: wrote no answer"},
    {"cat /dev/zero >&2", "no_answer: printed 8"},
    {"head -c 3000000 /dev/zero; echo 'x: y.cpp:3: f(): Assertion `a' \"' failed\"; "
     "kill -ABRT $$",
     "crashed: assertion 6, "},
    // What works isn't taken to have slept once it has ended, as a box shows it when it is killed.
    {"for i in 1 2 3; do perl -e '1 while (times)[0] + (times)[1] < .8'; done; exit 7",
     "no_answer: exited 7"},
    {kDaemon + "exit 0", "no_answer: exited 0"},
    {kDaemon + "exec sleep 1000", "timed_out: waited 0", true},
    // A box says on descriptor 5 that it is made; before, nobody's program is to blame.
    {"echo no room; exit 1", "kit: the box of a program couldn't be made", false, true},
    {"printf x >&5; exit 125", "kit: the box of a program couldn't be made", false, true},
    {"kill -KILL $$", "kit: the box of a program couldn't be made", false, true},
    {"printf m >&5; exit 1", "no_answer: exited 1", false, true},
    {"printf mx >&5; exit 125", "no_answer: not started", false, true},
    {"printf m >&5; sleep 0.2; printf x >&5", "no_answer: not started", false, true},
};

TEST(RunnerProcess, NamesTheEndOfARunner) {
  for (const Script& row : kScripts) {
    Limits limits;
    limits.boxed = row.boxed;
    const Termination end = end_of(row.script, limits);
    const std::string line = judge::in_one_line(end);
    EXPECT_EQ(line.rfind(row.end, 0), 0U) << row.script << ": " << line;
    EXPECT_EQ(end.waits, row.waits) << row.script;
  }
  EXPECT_NE(std::system("pgrep -f '[s]leep 54321' >/dev/null"), 0) << "a daemon is left behind";
}

// Sanitizers reserve more addresses than there is memory, so the system doesn't limit them.
TEST(RunnerProcess, EndsASanitizedOneThatStoresTooMuch) {
  Limits limits;
  limits.sanitized = true;
  limits.memory = std::size_t{64} << 20;
  const Termination end = end_of("exec perl -e '$x = \"x\" x (200 << 20); sleep 9'", limits);
  EXPECT_EQ(judge::in_one_line(end), "out_of_memory: out of memory 64");
}

TEST(RunnerProcess, EndsOneThatStartsThreadsAndSleepsBetweenThem) {
  const Termination end = end_of(
      kThreads + "while True:\n t = Thread(target=int)\n t.start()\n t.join()\n time.sleep(.02)'");
  EXPECT_TRUE(end.waits) << end.what;
}

// Ten others at work on its CPU: it has a tenth of it, and no answer for longer than one may sleep.
TEST(RunnerProcess, LetsOneThatWorksGoOnHoweverBusyTheMachineIs) {
  judge::stay_on_this_cpu();
  std::vector<std::unique_ptr<RunnerProcess>> others;
  const std::vector<std::string> busy{"/bin/sh", "-c", "exec perl -e '1 while 1'"};
  for (int i = 0; i < 10; ++i) others.push_back(std::make_unique<RunnerProcess>(busy, Limits()));
  Limits limits;
  limits.wall_seconds = 1;
  const Termination end = end_of("perl -e '1 while (times)[0] + (times)[1] < .5'; exit 7", limits);
  EXPECT_EQ(judge::in_one_line(end), "no_answer: exited 7");
}

TEST(RunnerProcess, EndsOneWhoseThreadsAllSleepWhileOthersUseTheCpu) {
  judge::stay_on_this_cpu();
  const RunnerProcess other({"/bin/sh", "-c", "exec perl -e '1 while 1'"}, Limits());
  const Termination end =
      end_of(kThreads + "Thread(target=time.sleep, args=(999,)).start()\ntime.sleep(999)'");
  EXPECT_TRUE(end.waits) << end.what;
}

TEST(RunnerProcess, CountsNoTimeInWhichTheJudgeItselfIsStopped) {
  const std::string frozen = "kill -STOP $PPID; sleep 3; kill -CONT $PPID; " + kFrame;
  RunnerProcess runner({"/bin/sh", "-c", frozen + "exec sleep 1000"}, Limits());
  EXPECT_NO_THROW(runner.receive());
}

TEST(RunnerProcess, LeavesOtherRunnersAlone) {
  RunnerProcess other({"/bin/sh", "-c", kFrame + "exec sleep 1000"}, Limits());
  EXPECT_EQ(end_of("exit 0").status, "no_answer");
  EXPECT_EQ(other.receive().magic, frames::kMagic);
}

}  // namespace
}  // namespace bounce::tests
