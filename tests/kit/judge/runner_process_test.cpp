// How the judge treats runners that break the protocol; shell commands stand in for them.
#include "../../../grader/judge/runner_process.hpp"
#include "../../../grader/judge/process_usage.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <string>

namespace bounce::tests {
namespace {

using judge::RunnerEnded;
using judge::RunnerProcess;

// How one question to a shell command ends.
RunnerEnded end_of(const std::string& script) {
  std::signal(SIGPIPE, SIG_IGN);
  RunnerProcess runner({"/bin/sh", "-c", script}, judge::Limits());
  try {
    for (;;) {
      runner.send(frames::Frame());
      runner.receive();
    }
  } catch (const RunnerEnded& ended) {
    return ended;
  }
}

void expect(const std::string& script, const std::string& status, const std::string& words,
            bool waits = false) {
  const RunnerEnded end = end_of(script);
  EXPECT_EQ(end.termination.status, status) << script;
  EXPECT_NE(end.termination.sentence.find(words), std::string::npos)
      << script << end.termination.sentence;
  EXPECT_EQ(end.waits, waits) << script;
}

// A frame begins with its magic number; the rest of this one is zeros.
const std::string kFrame = "{ printf BNB1; head -c " +
                           std::to_string(sizeof(frames::Frame) - sizeof frames::kMagic) +
                           " /dev/zero; } >&4; ";

TEST(RunnerProcess, NamesExitsAndSignals) {
  expect("exit 0", "no_answer", "exit status 0");
  expect("exit 7", "no_answer", "exit status 7");
  expect("kill -SEGV $$", "crashed", "segmentation fault");
  expect("kill -SYS $$", "crashed", "asked the system for what it isn't given");
  expect("kill -KILL $$", "crashed", "killed");
  expect("kill -TERM $$", "crashed", "SIGTERM");
}

TEST(RunnerProcess, EndsALoop) { expect("while :; do :; done", "timed_out", "1 s of CPU time"); }

TEST(RunnerProcess, EndsALoopThatIgnoresItsCpuLimit) {
  expect("trap '' XCPU; while :; do :; done", "timed_out", "1 s of CPU time");
}

TEST(RunnerProcess, SeesWhatALoopHasStored) {
  expect("exec perl -e '$stored = \"x\" x 2e8; while (1) {}'", "out_of_memory",
         "stores without end");
}

TEST(RunnerProcess, EndsOneThatSleeps) {
  expect("sleep 1000", "timed_out", "no answer came: the program waits for something", true);
  expect("cat <&3 >/dev/null", "timed_out", "waits for something", true);
  expect("trap '' TERM INT HUP; sleep 1000", "timed_out", "waits for something", true);
}

// Printing wakes the judge, which then always finds the program at work.
TEST(RunnerProcess, EndsOneThatPrintsBetweenSleeps) {
  for (const char* seconds : {"0.03", "0.001"}) {
    const std::string sleep = std::string("select(undef, undef, undef, ") + seconds + ")";
    expect("exec perl -e '$| = 1; while (1) { print \"x\\n\"; " + sleep + " }'", "timed_out",
           "waits for something", true);
  }
}

// On a busy machine nobody can tell how long threads that have ended wanted a CPU.
TEST(RunnerProcess, EndsOneThatSleepsWithThreadsOnceTheCpuHadNothingToDo) {
  const double before = judge::spare_seconds();
  RunnerProcess runner({NAPS_IN_THREADS}, judge::Limits());
  try {
    runner.receive();
    ADD_FAILURE();
  } catch (const RunnerEnded& end) {
    EXPECT_TRUE(end.waits);
  } catch (const judge::KitFailure& busy) {
    EXPECT_NE(std::string(busy.what()).find("too busy"), std::string::npos);
  }
  EXPECT_LT(judge::spare_seconds() - before, 2 * judge::Limits().idle_seconds);
}

// Where the box can't limit them, because it can't tell them from others of the same user.
TEST(RunnerProcess, EndsOneWithManyThreads) {
  const std::string start =
      "ulimit -s 256; export MALLOC_ARENA_MAX=1; python3 -c 'import threading, time\n"
      "for _ in range(40): threading.Thread(target=time.sleep, args=(9,)).start()'";
  expect(start, "crashed", "more than 32 threads");
}

TEST(RunnerProcess, CountsNoIdleTimeOfOneThatWorks) {
  RunnerProcess runner({"/bin/sh", "-c", "while :; do :; done"}, judge::Limits());
  EXPECT_THROW(runner.receive(), RunnerEnded);
  EXPECT_LT(runner.idle().count(), 0.5);
  EXPECT_GT(runner.spent(), 0.5);
}

TEST(RunnerProcess, CountsNoTimeInWhichTheJudgeItselfIsStopped) {
  const std::string frozen = "kill -STOP $PPID; sleep 3; kill -CONT $PPID; " + kFrame;
  RunnerProcess runner({"/bin/sh", "-c", frozen + "exec sleep 1000"}, judge::Limits());
  EXPECT_NO_THROW(runner.receive());
}

RunnerProcess boxed(const std::string& script) {
  judge::Limits limits;
  limits.boxed = true;
  return RunnerProcess({"/bin/sh", "-c", script}, limits);
}

TEST(RunnerProcess, BlamesNobodyForABoxThatIsNotMade) {
  for (const char* script : {"echo no room; exit 1", "printf x >&5; exit 125", "kill -KILL $$"}) {
    RunnerProcess runner = boxed(script);
    try {
      runner.receive();
      ADD_FAILURE() << script;
    } catch (const RunnerEnded&) {
      ADD_FAILURE() << script << " counts as the program's fault";
    } catch (const judge::KitFailure& error) {
      EXPECT_NE(std::string(error.what()).find("couldn't be made"), std::string::npos);
    }
  }
  RunnerProcess made = boxed("printf m >&5; exit 1");
  EXPECT_THROW(made.receive(), RunnerEnded);
}

TEST(RunnerProcess, BlamesNoBoxForAProgramThatCannotBeStarted) {
  for (const char* script : {"printf mx >&5; exit 125", "printf m >&5; sleep 0.2; printf x >&5"}) {
    RunnerProcess runner = boxed(script);
    try {
      runner.receive();
      ADD_FAILURE() << script;
    } catch (const RunnerEnded& ended) {
      EXPECT_NE(std::string(ended.what()).find("can't start the program"), std::string::npos);
    }
  }
}

TEST(RunnerProcess, EndsOneThatIsStopped) {
  expect("kill -STOP $$", "timed_out", "the program stopped itself", true);
}

TEST(RunnerProcess, AddsUpTheSleepBeforeEveryAnswer) {
  const auto start = std::chrono::steady_clock::now();
  expect("while :; do sleep 0.6; " + kFrame + "done", "timed_out", "waits for something", true);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
}

TEST(RunnerProcess, NamesAShortAnswer) {
  expect("printf BNB1 >&4; sleep 1000", "timed_out", "only a part of an answer came", true);
  expect("printf BNB1 >&4", "no_answer", "exit status 0");
}

TEST(RunnerProcess, NamesClosedPipes) {
  expect("exec 4>&-; exec sleep 1000", "no_answer", "the pipe of its answers", true);
  expect("exec 3<&-; " + kFrame + "exec sleep 1000", "no_answer", "the pipe of its questions",
         true);
}

TEST(RunnerProcess, RefusesWhatIsNoAnswer) {
  expect("cat /dev/zero >&4", "no_answer", "isn't the answer that was asked for");
  expect("cat /dev/zero >&4; sleep 1000", "no_answer", "isn't the answer that was asked for");
}

TEST(RunnerProcess, EndsAFloodOfPrints) {
  expect("cat /dev/zero", "no_answer", "printed more than 8 MB");
  expect("cat /dev/zero >&2", "no_answer", "printed more than 8 MB");
}

TEST(RunnerProcess, ReadsTheEndOfALongPrint) {
  expect(
      "head -c 3000000 /dev/zero; echo 'x: y.cpp:3: f(): Assertion `a' \"' failed\"; kill -ABRT $$",
      "crashed", "an assertion failed: y.cpp:3: a");
}

TEST(RunnerProcess, EndsWhatARunnerLeavesBehind) {
  // A daemon: its parent is gone, and it has a session of its own.
  const std::string daemon = "(setsid sh -c 'exec sleep 54321 >/dev/null 2>&1 3<&- 4>&-' &); ";
  expect(daemon + "exit 0", "no_answer", "exit status 0");
  expect(daemon + "exec sleep 1000", "timed_out", "waits for something", true);
  EXPECT_NE(std::system("pgrep -f '[s]leep 54321' >/dev/null"), 0);
}

TEST(RunnerProcess, LeavesOtherRunnersAlone) {
  RunnerProcess other({"/bin/sh", "-c", kFrame + "exec sleep 1000"}, judge::Limits());
  expect("exit 0", "no_answer", "exit status 0");
  EXPECT_EQ(other.receive().magic, frames::kMagic);
}

TEST(RunnerProcess, IsNotKeptWaitingByOneThatDoesNotRead) {
  RunnerProcess runner({"/bin/sh", "-c", "exec sleep 1000"}, judge::Limits());
  EXPECT_THROW(for (int i = 0; i < 1000; ++i) runner.send(frames::Frame()), RunnerEnded);
}

}  // namespace
}  // namespace bounce::tests
