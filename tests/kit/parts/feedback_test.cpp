// The feedback on a wrong answer, and on a part that throws, in a student's own build.
#include <cmath>
#include <stdexcept>
#include <utility>

#include "../../parts/checks.hpp"
#include "../../parts/linked/linked.hpp"
#include "../../parts/submission.hpp"
#include "expected_texts.hpp"

namespace bounce::tests {
namespace {

Case some_case() {
  Case c;
  c.tolerance = 1e-9;
  c.corner = "corner 3 touches and slides to the right";
  return c;
}

using Matrix = Eigen::MatrixXd;

std::string told(const Case& c, const Matrix& expected, const Matrix& got, bool always_zero) {
  Failure failure{c, compare(c, "a quantity", "m", expected, got)};
  failure.always_zero = always_zero;
  return words::numbers(failed_case(failure), true);
}

Matrix scalar(double x) { return Matrix::Constant(1, 1, x); }

TEST(feedback, MarksWhatIsWrongAndSaysWhatMayBeTheCause) {
  const Case c = some_case();
  const struct {
    const char* name;
    Matrix right, got;
    bool always_zero = false;
  } rows[] = {
      {"one entry, beside a rounding error", Vector3(0, 2, 3), Vector3(-6.9e-17, 5, 3)},
      {"in the eighth digit", Vector3(1, 2, 3), Vector3(1, 2.0000001, 3)},
      {"nan", Vector3(1, 2, 3), Vector3(1, NAN, 3)},
      {"nan with a sign", Vector3(1, 2, 3), Vector3(1, -NAN, 3)},
      {"infinite", Vector3(1, 2, 3), Vector3(1, -INFINITY, 3)},
      {"zeros", Vector3(1, 2, 3), Vector3(0, 0, 0), true},
      {"zeros in this case alone", Vector3(1, 2, 3), Vector3(0, 0, 0)},
      {"a scalar that is nan", scalar(0.2), scalar(NAN)},
      {"a scalar that was never set", scalar(0.2), scalar(-5.4e303)},
      {"a large scalar", scalar(0.2), scalar(2e29)},
  };
  Texts texts;
  for (const auto& row : rows)
    texts.emplace_back(row.name, told(c, row.right, row.got, row.always_zero));
  expect_texts("feedback.txt", texts);
}

std::string thrown(Contact (*part)(const Vector3&, const Parameters&)) {
  const auto right = std::exchange(linked<&bounce::get_contacts>, part);
  std::string text;
  try {
    Linked own;
    submission::get_contacts(own, Vector3::Zero(), {});
  } catch (const std::runtime_error& error) {
    text = error.what();
  }
  linked<& bounce::get_contacts> = right;
  return text;
}

TEST(feedback, NamesThePartAndSaysWhatItSaid) {
  using Q = const Vector3&;
  using P = const Parameters&;
  EXPECT_EQ(thrown([](Q, P) -> Contact { throw std::runtime_error("oh"); }),
            "part 1 threw an exception: \"oh\"");
  EXPECT_EQ(thrown([](Q, P) -> Contact { throw "oh"; }), "part 1 threw an exception: \"oh\"");
  EXPECT_EQ(thrown([](Q, P) -> Contact { throw 7; }),
            "part 1 threw something that isn't a std::exception");
}

}  // namespace
}  // namespace bounce::tests
