// The feedback on a wrong answer, and on a part that throws, in a student's own build.
#include "../../parts/feedback.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "../../parts/linked/thrown.hpp"

namespace bounce::tests {
namespace {

Case some_case() {
  Case c;
  c.tolerance = 1e-9;
  c.q = {0.5, 0.12, 0.3};
  c.v = {3, -1, 2};
  c.corner = "corner 3 touches and slides to the right";
  c.state = {Vector3(0.5, 0.12, 0.2), Vector3(2.5, -0.2, -11)};
  return c;
}

std::string told(const Case& c, const Eigen::MatrixXd& expected, const Eigen::MatrixXd& got,
                 const std::string& name = "a quantity") {
  return feedback(c, compare(c, name, "m", expected, got));
}

bool says(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

TEST(feedback, MarksWhatIsWrongAndNamesAFactorOrWhatIsNoNumber) {
  const Case c = some_case();
  const Vector3 right(1, 2, 3);
  const struct {
    Vector3 got;
    const char* says;
    const char* never = "\n\n\n";
  } rows[] = {
      {{1, 5, 3}, "[ 1 ]             [ 1 ]"},
      {{1, 5, 3}, "[>5<]             [ 2 ]"},
      {{1, 5, 3}, "a quantity, in m\n", "[>3<]"},
      {{1, 2.0000001, 3}, ">2.0000001<"},
      {-right, "wrong entries are -1 times the right ones"},
      {right / c.params.dt, "1/dt = 100 times the right ones"},
      {{1, 2, 3 * c.params.m}, " m or mu = 0.3 times the right ones"},
      {{-1, 2, 7}, "", "times the right ones"},
      {{1, NAN, 3}, ">nan<"},
      {{1, -NAN, 3}, "an entry is nan: was it ever set?"},
      {{1, -INFINITY, 3}, "an entry is -inf: a division by zero?"},
      {{0, 0, 0}, "is it filled in?"},
  };
  for (const auto& row : rows) {
    const std::string text = told(c, right, row.got);
    EXPECT_TRUE(says(text, row.says)) << text;
    EXPECT_FALSE(says(text, row.never)) << text;
  }
  EXPECT_FALSE(says(told(c, Vector3(1, 0, 3), Vector3(-1, 5, 3)), "times the right ones"));
  const Eigen::MatrixXd phi = Eigen::MatrixXd::Constant(1, 1, 0.2);
  EXPECT_TRUE(says(told(c, phi, NAN * phi), "it is nan: was it ever set?"));
  EXPECT_TRUE(says(told(c, phi, -2.7e304 * phi), "it is -5.4e+303: was it ever set?"));
  EXPECT_FALSE(says(told(c, phi, 1e30 * phi), "ever set"));
}

TEST(feedback, TellsTheForceAndDrawsTheStep) {
  Case c = some_case();
  // f_e is taken off: a corner that isn't pushed has the velocity of free flight.
  const Vector3 free = c.v + c.params.dt * c.params.g;
  const std::string text = told(c, c.state.v, free, kNewVelocity);
  EXPECT_TRUE(says(text, "yours (0, 0) N, right (-15, 26.943) N")) << text;
  EXPECT_TRUE(says(text, "corner 3 touches and slides to the right")) << text;
  for (const char* letter : {"o", "+", "R", "Y", "#", "====="}) {
    EXPECT_TRUE(says(text.substr(text.find("    | ")), letter)) << letter << "\n" << text;
  }
  c.corner = "no corner touches; corner 3 is the lowest";
  EXPECT_FALSE(says(told(c, c.state.v, free, kNewVelocity), "contact force"));
  EXPECT_FALSE(says(told(c, c.v, free, "v in column 0"), "after the step"));
}

TEST(feedback, DrawsBothPaths) {
  Case c = some_case();
  c.columns = {0, 1, 2};
  c.trajectory.q = Eigen::Matrix3Xd::Zero(3, 3);
  c.trajectory.q.row(0) << 0, 1, 2;
  c.trajectory.q.row(1) << 1, 0.5, 0.2;
  Eigen::Matrix3Xd got = c.trajectory.q;
  got(1, 2) = 0.9;
  got(0, 1) = NAN;  // not drawn, and no harm
  Problem problem = compare(c, "q", kConfiguration, c.trajectory.q, got);
  problem.path = got;
  const std::string text = feedback(c, problem);
  for (const char* letter : {"B", "R", "Y", "====="}) {
    EXPECT_TRUE(says(text.substr(text.find("    | ")), letter)) << letter << "\n" << text;
  }
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    EXPECT_LE(end - at, 76u) << text.substr(at, end - at);
    at = end + 1;
  }
}

TEST(summary, PutsTheWrongEntriesInBrackets) {
  Case c = some_case();
  Eigen::MatrixXd right(2, 2), got(2, 2);
  right << 1, 2, 3, 4;
  got << 1, 2, -NAN, 4;
  const auto said = [&](const Eigen::MatrixXd& expected, const Eigen::MatrixXd& answer) {
    return summary(c, compare(c, "V", "s/kg", expected, answer));
  };
  EXPECT_EQ(said(right, got),
            "  expected V = (1, 2)\n               (3, 4)  s/kg\n"
            "  got      V = (1, 2)\n               ([nan], 4)  s/kg, [wrong]");
  EXPECT_TRUE(says(said(Vector3(1, 2, 3), Vector3(1, -2, 3)), "V = (1, [-2], 3)  s/kg, [wrong]"));
  EXPECT_TRUE(says(said(right.row(0), got.row(1)), "V = ([nan], [4])  s/kg, [wrong]"));
  const Eigen::MatrixXd alone = Eigen::MatrixXd::Constant(1, 1, 5);
  EXPECT_TRUE(says(said(alone, 2 * alone), "got      V = 10  s/kg"));
  EXPECT_FALSE(says(said(alone, 2 * alone), "["));
  c.hidden = true;
  EXPECT_TRUE(says(said(Vector3(1, 2, 3), Vector3(1, -2, 3)), "V = (1, [-2], 3)  s/kg, [wrong]"));
}

TEST(feedback, DoesNotTellTheAnswerOfAHiddenCase) {
  Case c = some_case();
  c.hidden = true;
  const std::string text = told(c, Vector3(17, 2.5, -11), Vector3(1, 2, 3), kNewVelocity);
  for (const char* answer : {"17", "2.5", "-11", "corner", "right", ">", "|"}) {
    EXPECT_FALSE(says(text, answer)) << text;
  }
  EXPECT_TRUE(says(text, "is not shown, this case is hidden")) << text;
}

template <class Thrown>
std::string thrown(const Thrown& what) {
  try {
    naming_the_part("part 1", [&]() -> int { throw what; });
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(feedback, NamesThePartAndSaysWhatItSaid) {
  EXPECT_EQ(thrown(std::out_of_range("oh")), "part 1 threw an exception: oh");
  EXPECT_EQ(thrown(std::string("oh")), "part 1 threw: oh");
  EXPECT_EQ(thrown<const char*>("oh"), "part 1 threw: oh");
  EXPECT_EQ(thrown(5), "part 1 threw something that isn't a std::exception");
  EXPECT_EQ(naming_the_part("part 1", [] { return 5; }), 5);
}

}  // namespace
}  // namespace bounce::tests
