// The feedback on a wrong answer, and on a part that throws, in a student's own build.
#include "../../../grader/diagnosis/feedback.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "../../parts/linked/linked.hpp"
#include "../../parts/submission.hpp"
#include "expected_texts.hpp"

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

using Matrix = Eigen::MatrixXd;

std::string told(const Case& c, const Matrix& expected, const Matrix& got,
                 const std::string& name = "a quantity") {
  return feedback(c, compare(c, name, "m", expected, got));
}

Matrix scalar(double x) { return Matrix::Constant(1, 1, x); }

TEST(feedback, MarksWhatIsWrongAndSaysWhatMayBeTheCause) {
  const Case c = some_case();
  const struct {
    const char* name;
    Matrix right, got;
  } rows[] = {
      {"one entry", Vector3(1, 2, 3), Vector3(1, 5, 3)},
      {"in the eighth digit", Vector3(1, 2, 3), Vector3(1, 2.0000001, 3)},
      {"times -1", Vector3(1, 2, 3), Vector3(-1, -2, -3)},
      {"times 1 / dt", Vector3(1, 2, 3), Vector3(100, 200, 300)},
      {"one entry times m, or mu", Vector3(1, 2, 3), Vector3(1, 2, 3 * c.params.m)},
      {"two factors", Vector3(1, 2, 3), Vector3(-1, 2, 7)},
      {"a factor, and not of 0", Vector3(1, 0, 3), Vector3(-1, 5, 3)},
      {"nan", Vector3(1, 2, 3), Vector3(1, NAN, 3)},
      {"nan with a sign", Vector3(1, 2, 3), Vector3(1, -NAN, 3)},
      {"infinite", Vector3(1, 2, 3), Vector3(1, -INFINITY, 3)},
      {"zeros", Vector3(1, 2, 3), Vector3(0, 0, 0)},
      {"a scalar that is nan", scalar(0.2), scalar(NAN)},
      {"a scalar that was never set", scalar(0.2), scalar(-5.4e303)},
      {"a large scalar", scalar(0.2), scalar(2e29)},
  };
  Texts texts;
  for (const auto& row : rows) texts.emplace_back(row.name, told(c, row.right, row.got));
  expect_texts("feedback.txt", texts);
}

TEST(feedback, TellsTheForceWhereACornerTouches) {
  Texts texts;
  Case c = some_case();
  // f_e is taken off: a corner that isn't pushed has the velocity of free flight.
  const Vector3 free = c.v + c.params.dt * c.params.g;
  texts.emplace_back("a new velocity", told(c, c.state.v, free, kNewVelocity));
  texts.emplace_back("column 0, without the step", told(c, c.v, free, "v in column 0"));
  c.corner = "no corner touches; corner 3 is the lowest";
  texts.emplace_back("in flight, without a force", told(c, c.state.v, free, kNewVelocity));
  expect_texts("forces.txt", texts);
}

std::string thrown(Contact (*part)(const Vector3&, const Parameters&)) {
  const auto right = std::exchange(linked<&bounce::get_contacts>, part);
  std::string text;
  try {
    submission::get_contacts(Vector3::Zero(), {});
  } catch (const std::runtime_error& error) {
    text = error.what();
  }
  linked<& bounce::get_contacts> = right;
  return text;
}

TEST(feedback, NamesThePartAndSaysWhatItSaid) {
  using Q = const Vector3&;
  using P = const Parameters&;
  EXPECT_EQ(thrown([](Q, P) -> Contact { throw std::string("oh"); }), "part 1 threw: oh");
  EXPECT_EQ(thrown([](Q, P) -> Contact { throw "oh"; }), "part 1 threw: oh");
}

}  // namespace
}  // namespace bounce::tests
