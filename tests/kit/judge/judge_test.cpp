// How the judge reads what isn't its own: frames of a runner, numbers, and the sizes of
// trajectories.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <csignal>

#include "../../../grader/judge/session.hpp"
#include "../../parts/checks.hpp"
#include "../../parts/submission.hpp"

namespace bounce {

namespace judge {
namespace {

using frames::Kind;

frames::Frame frame_of(Kind kind, std::uint32_t part, std::uint64_t number = 1) {
  frames::Frame frame;
  frame.kind = kind;
  frame.part = part;
  frame.number = number;
  return frame;
}

std::uint64_t always_one() { return 1; }

// How the first question of part 3 ends if a runner, which is only pipes here, sends these frames.
// The status is empty if the question is answered.
Termination end_after(const std::vector<frames::Frame>& frames, bool given) {
  std::signal(SIGPIPE, SIG_IGN);
  int questions[2], answers[2], prints[2];
  for (auto* pipe : {questions, answers, prints}) EXPECT_EQ(::pipe2(pipe, O_CLOEXEC), 0);
  const auto start = [&](const Limits& limits) {
    return std::make_unique<RunnerProcess>(questions[1], answers[0], prints[0], limits);
  };
  for (const frames::Frame& frame : frames) {
    EXPECT_EQ(::write(answers[1], &frame, sizeof frame), ssize_t{sizeof frame});
  }
  Session session(start, Limits(), 3, given, always_one);
  Termination end;
  try {
    session.ask(frame_of(Kind::question, 3), nullptr);
  } catch (const tests::Ended&) {
    end = session.take_end().value();
  }
  for (const int fd : {questions[0], answers[1], prints[1]}) ::close(fd);
  return end;
}

TEST(Session, TakesTheAnswerToItsQuestionAndAnswersForGivenPartsAlone) {
  const frames::Frame answer = frame_of(Kind::answer, 3);
  const struct {
    std::vector<frames::Frame> frames;
    bool given;
    const char* status;
    const char* what = "";
  } rows[] = {
      {{answer}, false, ""},
      {{frame_of(Kind::answer, 3, 2)}, false, "no_answer", "wrote no answer"},
      {{frame_of(Kind::answer, 2)}, false, "no_answer", "wrote no answer"},
      {{frame_of(Kind::question, 3)}, false, "no_answer", "wrote no answer"},
      {{frame_of(Kind::absent, 3)}, false, "does_not_compile", "absent"},
      {{frame_of(Kind::callback, 1), answer}, true, ""},
      {{frame_of(Kind::callback, 2), answer}, true, ""},
      {{frame_of(Kind::callback, 1), answer}, false, "no_answer", "asked"},
      {{frame_of(Kind::callback, 2), answer}, false, "no_answer", "asked"},
      {{frame_of(Kind::callback, 0), answer}, true, "no_answer", "asked"},
      {{frame_of(Kind::callback, 3), answer}, true, "no_answer", "asked"},
      {{frame_of(Kind::callback, 4), answer}, true, "no_answer", "asked"},
  };
  for (const auto& row : rows) {
    const Termination end = end_after(row.frames, row.given);
    const int i = static_cast<int>(&row - rows);
    EXPECT_EQ(end.status, row.status) << "row " << i;
    EXPECT_EQ(end.what, row.what) << "row " << i;
    EXPECT_EQ(end.of_no_case, end.status == "does_not_compile") << "row " << i;
  }
}

TEST(Session, AsksNoMoreWhenItsTimeIsUp) {
  Limits limits;
  limits.session_seconds = -1;
  const auto start = [](const Limits&) -> std::unique_ptr<RunnerProcess> {
    ADD_FAILURE() << "a runner is started";
    return nullptr;
  };
  Session session(start, limits, 1, false, always_one);
  EXPECT_THROW(session.ask(frames::Frame(), nullptr), tests::Ended);
  const Termination end = session.take_end().value();
  EXPECT_EQ(end.status, "no_answer");
  EXPECT_EQ(end.what, "not asked for want of time");
}

TEST(Session, StartsNoMoreOfAProgramThatHangs) {
  std::signal(SIGPIPE, SIG_IGN);
  Limits limits;
  limits.cpu_seconds = 1;
  limits.wall_seconds = 0.5;
  const struct {
    const char* script;
    bool given;
    int most;
  } rows[] = {
      {"exec sleep 9", false, 1},
      {"while :; do :; done", true, 1},
      // What they sleep counts together.
      {"sleep 0.4; exit 1", false, 4},
  };
  for (const auto& row : rows) {
    int runners = 0;
    const auto start = [&](const Limits& now) {
      ++runners;
      return std::make_unique<RunnerProcess>(std::vector<std::string>{"/bin/sh", "-c", row.script},
                                             now);
    };
    Session session(start, limits, 3, row.given, always_one);
    for (int i = 0; i < 6; ++i) {
      EXPECT_THROW(session.ask(frame_of(Kind::question, 3), nullptr), tests::Ended);
    }
    EXPECT_LE(runners, row.most) << row.script << " " << row.given;
  }
}

TEST(Session, TakesARunnerOrABoxThatCannotBeStartedForAFaultOfTheKit) {
  std::signal(SIGPIPE, SIG_IGN);  // as in the judge: the box may have ended before it is asked
  const auto throws = [](const Limits&) -> std::unique_ptr<RunnerProcess> {
    throw KitFailure("no process could be started");
  };
  const auto no_box = [](Limits limits) {
    limits.boxed = true;
    const std::vector<std::string> command{"/bin/sh", "-c", "echo no namespaces; exit 1"};
    return std::make_unique<RunnerProcess>(command, limits);
  };
  Session first(throws, {}, 1, false, always_one), second(no_box, {}, 1, false, always_one);
  EXPECT_THROW(first.ask(frames::Frame(), nullptr), tests::Ended);
  EXPECT_EQ(first.kit_failure(), "no process could be started");
  EXPECT_THROW(second.ask(frames::Frame(), nullptr), tests::Ended);
  EXPECT_NE(second.kit_failure().find("no namespaces"), std::string::npos);
  EXPECT_THROW(second.ask(frames::Frame(), nullptr), tests::Ended);
}

bool taken(const Eigen::MatrixXd& expected, const Eigen::MatrixXd& got) {
  tests::Case c;
  c.tolerance = 1e-9;
  return tests::compare(c, "x", "m", expected, got).empty();
}

TEST(Comparison, TakesAnErrorOfTheToleranceAndNoLargerOneAndNothingThatIsNoNumber) {
  for (const double right : {0.0, -1000.0}) {
    const double room = 1e-9 * std::max(1.0, std::abs(right));
    for (const double sign : {-1.0, 1.0}) {
      EXPECT_TRUE(taken(Vector3(1, right, 3), Vector3(1, right + sign * 0.9 * room, 3)));
      EXPECT_FALSE(taken(Vector3(1, right, 3), Vector3(1, right + sign * 1.1 * room, 3)));
    }
  }
  for (const double odd : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    for (Eigen::Index i = 0; i < 3; ++i) {
      Vector3 got(1, 2, 3);
      got(i) = odd;
      EXPECT_FALSE(taken(Vector3(1, 2, 3), got)) << odd << " in " << i;
    }
  }
}

}  // namespace
}  // namespace judge
}  // namespace bounce
