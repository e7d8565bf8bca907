// The judge against runners that break the protocol, with pipes instead of processes.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <cmath>
#include <csignal>
#include <ctime>
#include <sstream>
#include <thread>

#include "../../../grader/judge/assertion.hpp"
#include "../../../grader/judge/session.hpp"
#include "../../parts/cases.hpp"
#include "../../parts/submission.hpp"

namespace bounce {

std::vector<std::filesystem::path> tests::fixture_folders() { return {}; }
void tests::about_to_ask(const Case&) {}
std::string tests::in_words(const Case& c, const Problem& problem) {
  return tests::summary(c, problem);
}

namespace judge {
namespace {

// A runner that is only pipes: what the judge writes to and reads from, and the runner's ends.
struct Pipes {
  Pipes() {
    std::signal(SIGPIPE, SIG_IGN);
    for (auto* pipe : {questions, answers, prints}) EXPECT_EQ(::pipe2(pipe, O_CLOEXEC), 0);
  }
  ~Pipes() {
    for (const int fd : {questions[0], answers[1], prints[1]}) ::close(fd);
  }
  std::unique_ptr<RunnerProcess> runner(const Limits& limits) const {
    return std::make_unique<RunnerProcess>(questions[1], answers[0], prints[0], limits);
  }
  int questions[2], answers[2], prints[2];
};

TEST(RunnerProcess, IsEndedWhenItAsksWithoutReading) {
  const Pipes pipes;
  const auto runner = pipes.runner(Limits());
  try {
    for (int i = 0; i < 10000; ++i) runner->send(frames::Frame());
    FAIL() << "the pipe holds more than 10,000 frames";
  } catch (const RunnerEnded& ended) {
    EXPECT_EQ(ended.termination.status, "no_answer");
    EXPECT_NE(std::string(ended.what()).find("didn't read"), std::string::npos);
  }
}

TEST(RunnerProcess, IsEndedWhenItsAnswerComesByteByByte) {
  const Pipes pipes;
  Limits limits;
  limits.wall_seconds = 1;
  auto runner = pipes.runner(limits);
  std::atomic<bool> over = false;
  std::thread slow([&] {  // a whole frame would take ten seconds
    const frames::Frame answer;
    const char* bytes = reinterpret_cast<const char*>(&answer);
    for (std::size_t i = 0; i < sizeof answer && !over; ++i) {
      EXPECT_EQ(::write(pipes.answers[1], bytes + i, 1), 1);
      std::this_thread::sleep_for(std::chrono::milliseconds(25));
    }
  });
  try {
    runner->receive();
    ADD_FAILURE() << "it was waited for";
  } catch (const RunnerEnded& ended) {
    EXPECT_EQ(ended.termination.status, "timed_out");
    EXPECT_TRUE(ended.waits);
  }
  over = true;
  slow.join();
}

std::uint64_t always_one() { return 1; }

TEST(Session, AsksNoMoreWhenItsTimeIsUp) {
  Limits limits;
  limits.session_seconds = -1;
  int started = 0;
  Session session(
      [&](const Limits&) -> std::unique_ptr<RunnerProcess> {
        ++started;
        return nullptr;
      },
      limits, 1, false, always_one);
  EXPECT_THROW(session.ask(frames::Frame()), tests::Ended);
  const Session::End end = session.take_end().value();
  EXPECT_EQ(end.status, "no_answer");
  EXPECT_EQ(end.instead_of_cases.rfind("nothing was asked here: ", 0), 0U);
  EXPECT_EQ(started, 0);
}

TEST(Session, TakesARunnerThatCannotBeStartedForAFaultOfTheKit) {
  Session session(
      [](const Limits&) -> std::unique_ptr<RunnerProcess> {
        throw std::runtime_error("no process could be started");
      },
      {}, 1, false, always_one);
  EXPECT_THROW(session.ask(frames::Frame()), tests::Ended);
  EXPECT_EQ(session.kit_failure(), "no process could be started");
}

TEST(Session, RemembersThatTheKitHasFailed) {
  std::signal(SIGPIPE, SIG_IGN);  // as in the judge: the box may have ended before it is asked
  Session session(
      [&](const Limits& limits) -> std::unique_ptr<RunnerProcess> {
        const std::vector<std::string> command{"/bin/sh", "-c", "echo no namespaces; exit 1"};
        return std::make_unique<RunnerProcess>(command, limits);
      },
      [] {
        Limits limits;
        limits.boxed = true;
        return limits;
      }(),
      1, false, always_one);
  EXPECT_THROW(session.ask(frames::Frame()), tests::Ended);
  EXPECT_NE(session.kit_failure().find("no namespaces"), std::string::npos);
  EXPECT_THROW(session.ask(frames::Frame()), tests::Ended);
}

frames::Frame said(frames::Kind kind, std::uint32_t part, std::uint64_t number = 1) {
  frames::Frame frame;
  frame.kind = kind;
  frame.part = part;
  frame.number = number;
  return frame;
}

// How the first question of part 3 ends if a runner sends these frames; its status is empty if the
// question is answered.
Session::End whole_end_after(const std::vector<frames::Frame>& frames, bool given) {
  const Pipes pipes;
  Session session([&](const Limits& now) { return pipes.runner(now); }, Limits(), 3, given,
                  always_one);
  for (const frames::Frame& frame : frames) {
    EXPECT_EQ(::write(pipes.answers[1], &frame, sizeof frame), ssize_t{sizeof frame});
  }
  try {
    session.ask(said(frames::Kind::question, 3));
    return {};
  } catch (const tests::Ended&) {
    return session.take_end().value();
  }
}

std::string end_after(const std::vector<frames::Frame>& frames, bool given) {
  return whole_end_after(frames, given).status;
}

TEST(Session, CountsNoCaseAgainstAFunctionThatIsNotThere) {
  const Session::End end = whole_end_after({said(frames::Kind::absent, 3)}, false);
  EXPECT_EQ(end.status, "does_not_compile");
  EXPECT_EQ(end.instead_of_cases.rfind("the file defines no bounce::step ", 0), 0U);
  EXPECT_EQ(whole_end_after({said(frames::Kind::answer, 2)}, false).instead_of_cases, "");
}

TEST(Session, TakesTheAnswerToItsQuestionAndNoOther) {
  using frames::Kind;
  EXPECT_EQ(end_after({said(Kind::answer, 3)}, false), "");
  EXPECT_EQ(end_after({said(Kind::answer, 3, 2)}, false), "no_answer");
  EXPECT_EQ(end_after({said(Kind::answer, 2)}, false), "no_answer");
  EXPECT_EQ(end_after({said(Kind::question, 3)}, false), "no_answer");
}

TEST(Session, AnswersForEarlierPartsAloneAndOnlyWhereTheyAreGiven) {
  using frames::Kind;
  for (const std::uint32_t part : {1U, 2U}) {
    EXPECT_EQ(end_after({said(Kind::callback, part), said(Kind::answer, 3)}, true), "");
    EXPECT_EQ(end_after({said(Kind::callback, part), said(Kind::answer, 3)}, false), "no_answer");
  }
  for (const std::uint32_t part : {0U, 3U, 4U}) {
    EXPECT_EQ(end_after({said(Kind::callback, part), said(Kind::answer, 3)}, true), "no_answer");
  }
}

bool taken(const Eigen::MatrixXd& expected, const Eigen::MatrixXd& got) {
  tests::Case c;
  c.tolerance = 1e-9;
  return tests::compare(c, "x", "m", expected, got).empty();
}

bool taken(double expected, double got) {
  return taken(Eigen::MatrixXd::Constant(1, 1, expected), Eigen::MatrixXd::Constant(1, 1, got));
}

TEST(Comparison, TakesAnErrorOfTheToleranceAndNoLargerOne) {
  for (const double sign : {-1.0, 1.0}) {
    EXPECT_TRUE(taken(0, sign * 0.9e-9));
    EXPECT_FALSE(taken(0, sign * 1.1e-9));
    EXPECT_TRUE(taken(-1000, -1000 + sign * 0.9e-6));
    EXPECT_FALSE(taken(-1000, -1000 + sign * 1.1e-6));
  }
}

TEST(Comparison, NeverTakesWhatIsNoNumber) {
  for (const double odd : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    for (Eigen::Index i = 0; i < 3; ++i) {
      Vector3 got(1, 2, 3);
      got(i) = odd;
      EXPECT_FALSE(taken(Vector3(1, 2, 3), got)) << odd << " in " << i;
    }
  }
}

TEST(Comparison, OfTwoQuantitiesTellsTheDifferencesOfBoth) {
  tests::Case c;
  const auto right = tests::compare(c, "x", "m", 1, 1), wrong = tests::compare(c, "x", "m", 1, 2);
  EXPECT_TRUE(tests::both(right, right).empty());
  EXPECT_EQ(tests::both(right, wrong).differences.size(), 1U);
  EXPECT_EQ(tests::both(wrong, right).differences.size(), 1U);
  EXPECT_EQ(tests::both(wrong, wrong).differences.size(), 2U);
}

TEST(Trajectory, HasTheColumnsThatWereAskedInBothOfItsMatrices) {
  EXPECT_NO_THROW(submission::require_columns(5, 5, 5));
  EXPECT_THROW(submission::require_columns(4, 5, 5), std::runtime_error);
  EXPECT_THROW(submission::require_columns(5, 6, 5), std::runtime_error);
}

TEST(Trajectory, IsReadAsFarAsItWasAskedWhereNoMoreThanOneColumnIsMissing) {
  EXPECT_EQ(submission::columns_at_hand(5, 5, 5), 5);
  EXPECT_EQ(submission::columns_at_hand(6, 7, 5), 5);
  EXPECT_EQ(submission::columns_at_hand(4, 6, 5), 4);
  EXPECT_EQ(submission::columns_at_hand(6, 4, 5), 4);
  EXPECT_THROW(submission::columns_at_hand(3, 5, 5), std::runtime_error);
  EXPECT_THROW(submission::columns_at_hand(5, 3, 5), std::runtime_error);
  EXPECT_THROW(submission::columns_at_hand(0, 0, 1), std::runtime_error);
  EXPECT_THROW(submission::columns_at_hand(-1, std::int64_t{1} << 62, 1), std::runtime_error);
}

TEST(Assertion, ThatHasNoWordsIsToldWithItsPlace) {
  EXPECT_EQ(assertion_in("a print\nrunner: /usr/include/eigen3/Eigen/src/Core/Block.h:120: "
                         "Eigen::Block<X>::Block(X&, Index): Assertion `(i>=0) && (i<rows())' "
                         "failed.\nmore"),
            "Block.h:120: (i>=0) && (i<rows())");
}

// The text of Eigen's assertions is longer than a line.
TEST(Assertion, OfEigenSaysWhichOperation) {
  const auto told = [](const std::string& what) {
    return assertion_in("runner: /usr/include/eigen3/Eigen/src/Core/File.h:96: f(): Assertion `" +
                        what + "' failed.\n");
  };
  EXPECT_EQ(
      told("lhs.cols() == rhs.rows() && \"invalid matrix product\" && \"if you wanted a "
           "coeff-wise or a dot product use the respective explicit functions\""),
      "a product whose left matrix has another number of columns than the right one has rows");
  EXPECT_EQ(told("aLhs.rows() == aRhs.rows() && aLhs.cols() == aRhs.cols()"),
            "a sum, a difference or another operation by entries on two different shapes");
  EXPECT_EQ(told("((m_row+m_currentBlockRows) == m_xpr.rows() || m_xpr.cols() == 0) && m_col == "
                 "m_xpr.cols() && \"Too few coefficients passed to comma initializer "
                 "(operator<<)\""),
            "<< with fewer numbers than the matrix has");
  EXPECT_EQ(told("row >= 0 && row < rows() && col >= 0 && col < cols()"),
            "an index is out of range");
  EXPECT_EQ(told("(i>=0) && ( ((BlockRows==1) && (BlockCols==XprType::ColsAtCompileTime) && "
                 "i<xpr.rows()) ||((BlockRows==XprType::RowsAtCompileTime) && (BlockCols==1) && "
                 "i<xpr.cols()))"),
            "a row or a column that the matrix doesn't have");
}

TEST(Assertion, OfTheLibraryIsToldInWords) {
  EXPECT_EQ(assertion_in("/usr/include/c++/12/bits/stl_vector.h:1123: f: Assertion "
                         "'__n < this->size()' failed.\n"),
            "an index beyond the end of a std::vector or std::array");
}

TEST(Assertion, IsNotSeenInOtherWords) {
  for (const char* print : {"", "Assertion `x' failed", "x:1: Assertion x failed", "x:1: no more",
                            ":1: Assertion `x' failed", "x:: Assertion `x' failed"}) {
    EXPECT_EQ(assertion_in(print), "") << print;
  }
}

double cpu_seconds_to_read(const std::string& print) {
  const std::clock_t start = std::clock();
  assertion_in(print);
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

// A megabyte, far more than is ever kept. A careless reader takes quadratic time, or worse.
TEST(Assertion, IsFoundInNoTimeWhateverWasPrinted) {
  for (const std::string word : {"a", ":1", "a:1: ", "1:", "Assertion `", "a:1: Assertion `", "\n",
                                 "' failed", "a:1: Assertion `x' faile"}) {
    std::string print;
    while (print.size() < 1'000'000) print += word;
    EXPECT_LT(cpu_seconds_to_read(print), 1) << word;
  }
}

std::vector<tests::Case> read(const std::string& text) {
  std::istringstream file(R"({"checks": {"c": [)" + text + "]}}");
  return tests::read_cases(file, "c", false);
}

std::string with(const std::string& T, const std::string& expected) {
  return R"({"name": "x", "tolerance": 1e-9, "params": {"l": 1, "m": 1, "mu": 1, "epsilon": 1,
             "g": [0, 1, 0], "dt": 1, "delta": 1, "T": )" +
         T + R"(}, "input": {"q_0": [1, 2, 3]}, "expected": )" + expected + "}";
}

TEST(Fixtures, AreReadWhereTheyAreWhole) {
  const auto cases = read(with("2", R"({"columns": [1], "q": [[1, 2, 3]], "v": [[4, 5, 6]]})"));
  ASSERT_EQ(cases.size(), 1U);
  EXPECT_EQ(cases[0].params.T, 2);
  EXPECT_EQ(cases[0].trajectory.v(2, 0), 6);
}

TEST(Fixtures, AreRefusedWhereSomethingIsMissingOrOdd) {
  for (const char* T : {"0", "-1", "1.5", "1e300", "99999999999", "18446744073709551615", "null"}) {
    EXPECT_THROW(read(with(T, "{}")), std::exception) << T;
  }
  for (const char* expected :
       {R"({"phi": 1})", R"({"V": [[1]], "p": [1, 2, 3, 4]})", R"({"v": [1, 2, 3]})",
        R"({"columns": [2], "q": [[1, 2, 3]], "v": [[4, 5, 6]]})",
        R"({"columns": [-1], "q": [[1, 2, 3]], "v": [[4, 5, 6]]})",
        R"({"columns": [0, 1], "q": [[1, 2, 3]], "v": [[4, 5, 6]]})",
        R"({"columns": [0], "q": [], "v": []})", R"({"q": [1, 2], "v": [1, 2, 3]})",
        R"({"q": [1, 2, 3, 4], "v": [1, 2, 3]})"}) {
    EXPECT_THROW(read(with("2", expected)), std::exception) << expected;
  }
}

}  // namespace
}  // namespace judge
}  // namespace bounce
