// The patterns found in made-up wrong answers.
#include "../../parts/pattern.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace bounce::tests {
namespace {

constexpr int kCases = 12;

using Change = std::function<void(const Case&, Eigen::VectorXd&)>;

// Four of them with another l and m; the corners, and what they do, in turn.
std::vector<Case> some_cases() {
  std::vector<Case> cases;
  for (int k = 0; k < kCases; ++k) {
    Case c;
    c.q = {0.5 * k + 1, 0.3, k % 2 == 0 ? 0.4 + k : -0.7 - k};
    c.v = {1.5 - k, -1, 0.5};
    c.J << 1, 0, 0, 1, 0.1, 0.2;
    c.corner = "corner " + std::to_string(k % 4 + 1) +
               (k % 4 < 2 ? " touches and slides to the right" : " touches and sticks");
    c.params.T = 5;
    if (k >= 8) c.params.l = c.params.m = 0.7;
    cases.push_back(c);
  }
  return cases;
}

std::vector<Answer> right_answers(int part) {
  const int size = part == 1 ? 7 : part == 2 ? 20 : part == 3 ? 6 : 30;
  std::vector<Answer> answers;
  for (int k = 0; k < kCases; ++k) {
    Answer answer{Eigen::VectorXd(size), ""};
    for (int i = 0; i < size; ++i) answer.numbers(i) = 1 + 0.37 * i + 1.1 * k * (i % 3 + 1);
    answers.push_back(answer);
  }
  return answers;
}

std::string told(int part, const Change& change) {
  const std::vector<Case> cases = some_cases();
  std::vector<Answer> got = right_answers(part);
  for (std::size_t k = 0; k < cases.size(); ++k) change(cases[k], got[k].numbers);
  std::string text;
  for (const auto& sentence : patterns(part, cases, right_answers(part), got)) {
    text += sentence + "\n";
  }
  return text;
}

bool says(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

TEST(pattern, SaysNothingOfRightAnswers) {
  for (const int part : {1, 2, 3, 4}) {
    EXPECT_EQ(told(part, [](const Case&, Eigen::VectorXd&) {}), "");
  }
}

TEST(pattern, SaysNothingOfAStub) {
  EXPECT_EQ(told(1, [](const Case&, auto& x) { x.setZero(); }), "");
}

TEST(pattern, NamesWhatIsRightAndWhatIsWrong) {
  const std::string text = told(1, [](const Case& c, auto& x) { x(2) += c.q(0) * c.q(2); });
  EXPECT_TRUE(says(text, "Right in every public case: J_n and phi; wrong: J_t (third entry)."))
      << text;
  EXPECT_FALSE(says(text, "times") || says(text, "only where")) << text;
}

TEST(pattern, NamesAFactorAndASign) {
  EXPECT_TRUE(says(told(1, [](const Case&, auto& x) { x(5) = -x(5); }),
                   "Every wrong number is -1 times the right one."));
  EXPECT_TRUE(says(told(2, [](const Case& c, auto& x) { x *= c.params.m; }),
                   "Every wrong number is m times the right one."));
  EXPECT_TRUE(says(told(3, [](const Case&, auto& x) { x.tail(3) *= 0.75; }),
                   "Every wrong number is 0.75 times the right one."));
}

TEST(pattern, NamesTheFactorsOfTwoQuantities) {
  const std::string text = told(1, [](const Case&, auto& x) {
    x(2) = -x(2);
    x(6) *= 2;
  });
  EXPECT_TRUE(says(text, "Every wrong number in J_t is -1 times the right one.")) << text;
  EXPECT_TRUE(says(text, "phi is 2 times the right one.")) << text;
}

TEST(pattern, NamesADifferenceThatIsAlwaysTheSame) {
  EXPECT_TRUE(says(told(2, [](const Case&, auto& x) { x(16) += 0.5; }),
                   "Every wrong number is 0.5 more than the right one."));
}

TEST(pattern, NamesANumberThatIsTheSameWhateverTheQuestion) {
  EXPECT_TRUE(says(told(1, [](const Case&, auto& x) { x(6) = 0; }),
                   "Every wrong number is 0, whatever the question."));
}

TEST(pattern, NamesExchangedPlaces) {
  EXPECT_TRUE(says(told(1,
                        [](const Case&, auto& x) {
                          const Eigen::Vector3d first = x.head(3);
                          x.head(3) = x.segment(3, 3).eval();
                          x.segment(3, 3) = first;
                        }),
                   "the two columns of J are exchanged"));
  EXPECT_TRUE(says(told(2,
                        [](const Case&, auto& x) {
                          Eigen::Map<Eigen::Matrix4d> V(x.data());
                          V.transposeInPlace();
                        }),
                   "V is transposed"));
  EXPECT_TRUE(says(told(2, [](const Case&, auto& x) { std::swap(x(17), x(18)); }),
                   "p(1) and p(2) are exchanged"));
}

TEST(pattern, NamesTheParametersThatMayBeWrittenDown) {
  const std::string text = told(2, [](const Case& c, auto& x) {
    if (c.params.l != 0.2) x(0) += c.q(0) * c.q(0);
  });
  EXPECT_TRUE(says(text, "Wrong only where l or m aren't the assignment's, in all 4 such cases"))
      << text;
}

TEST(pattern, NamesTheCornerTheModeAndTheAngle) {
  const auto where = [](const std::function<bool(const Case&)>& is_wrong) {
    return told(3, [&](const Case& c, auto& x) {
      if (is_wrong(c)) x(4) += c.q(0) * c.v(0);
    });
  };
  EXPECT_TRUE(says(where([](const Case& c) { return c.corner[7] == '2'; }),
                   "Wrong only where corner 2 is the lowest, in all 3 such cases."));
  EXPECT_TRUE(says(where([](const Case& c) { return c.corner[7] != '2'; }),
                   "Wrong only where corner 2 is not the lowest, in all 9 such cases."));
  EXPECT_TRUE(says(where([](const Case& c) { return c.corner[7] >= '3'; }),
                   "Wrong only where the corner sticks, in all 6 such cases."));
  EXPECT_TRUE(says(where([](const Case& c) { return c.q(2) < 0; }),
                   "Wrong only where theta is negative, in all 6 such cases."));
}

TEST(pattern, NamesNoCasesWhereTooFewAreRight) {
  const std::string text = told(3, [](const Case& c, auto& x) {
    if (c.q(0) > 1.6) x(4) += c.q(0);
  });
  EXPECT_FALSE(says(text, "only where")) << text;
}

TEST(pattern, NamesTooFewDigits) {
  const std::string text =
      told(1, [](const Case&, auto& x) { x = x.template cast<float>().template cast<double>(); });
  EXPECT_TRUE(says(text, "is there a float")) << text;
}

TEST(pattern, NamesTheFirstWrongColumn) {
  const auto from = [](Eigen::Index column) {
    return told(4, [column](const Case&, auto& x) { x.tail(x.size() - 6 * column) *= 1.5; });
  };
  EXPECT_TRUE(says(from(0), "Column 0 is the first wrong one in every case that is wrong."));
  EXPECT_TRUE(says(from(1), "Column 1 is the first wrong one in every case that is wrong."));
  EXPECT_TRUE(says(from(3), "Column 0 is right in every public case"));
}

TEST(pattern, LeavesOutWhatIsNoNumberAndWhatThrew) {
  std::vector<Answer> got = right_answers(1);
  got[3] = {{}, "thrown"};
  got[4].numbers(6) = NAN;
  const auto told = patterns(1, some_cases(), right_answers(1), got);
  ASSERT_FALSE(told.empty());
  EXPECT_TRUE(says(told[0], "wrong: phi."));
  EXPECT_TRUE(patterns(1, some_cases(), right_answers(1), {}).empty());
}

}  // namespace
}  // namespace bounce::tests
